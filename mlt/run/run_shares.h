// How the parts of several runs (groups, or films that groups share) count in what is made of all.
//
// A run is the mean of its parts, and all are the mean of the runs by their weights.  Without one of n
// parts the mean of its run moves by 1/(n - 1) of how far the part is from it; that of all parts, of
// which it is the share u, by u/(1 - u).
#pragma once

namespace wander {

struct RunShare {
  double share;  // of the run among all
  double pull;   // what moves its mean by leaving out a part moves all by so many times as much
};

// Of a run of so many parts, each of which has this weight among all.
inline RunShare share_of_run(double parts, double weight, double all) {
  const double each = weight / all;
  return {parts * each, parts > 1 ? (parts - 1) * each / (1 - each) : 1};
}

}  // namespace wander
