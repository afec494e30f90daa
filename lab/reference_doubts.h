// Why a film may be no measure of another that is held against it: the same words wherever that is done.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "records/run_record.h"

namespace wander {

inline constexpr std::string_view doubt_of_another_scene =
    "is of another scene, by its text or by a mesh or texture";
inline constexpr std::string_view doubt_of_one_seed =
    "both are of one seed: they agree better than they are right, as far as they were made of the "
    "same samples; take runs of two seeds (-s)";

// The seeds of its samples, of several if it is merged; none of a film without samples.
std::vector<std::uint64_t> seeds_of(const Rendering& rendering);
// May two films be of the same samples, by their scenes and seeds, so that they differ by less than their errors say?
bool may_share_samples(const RunRecord& run, const RunRecord& reference);

// Is a film with paths of up to so many vertices held against one with longer or shorter ones?  Where that is not known,
// no; and what is wrong with it, in words that follow "has".
bool has_other_lengths(const Rendering& reference, int max_vertices);
std::string words_of_lengths(const Rendering& reference, int max_vertices);

// All of these of a run and its reference, each a sentence.
std::vector<std::string> doubts_of(const RunRecord& reference, const RunRecord& run);

}  // namespace wander
