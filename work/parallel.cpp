#include "work/parallel.h"

#include <tbb/concurrent_queue.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace wander {

namespace {

int available_threads() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Threads that stay until they are let go: so many can be there at one time.
class StartedThreads {
 public:
  StartedThreads() = default;
  ~StartedThreads() {
    {
      const std::lock_guard lock(mutex_);
      may_end_ = true;
    }
    end_.notify_all();
    for (std::thread& thread : threads_) thread.join();
  }
  StartedThreads(const StartedThreads&) = delete;
  StartedThreads& operator=(const StartedThreads&) = delete;

  bool start_one() {
    try {
      threads_.emplace_back([this] {
        std::unique_lock lock(mutex_);
        memory_.emplace_back(4096, '\0');  // asked for by this thread, as by one that works
        end_.wait(lock, [this] { return may_end_; });
      });
      return true;
    } catch (const std::system_error&) {
      return false;
    }
  }

 private:
  std::mutex mutex_;
  std::condition_variable end_;
  bool may_end_ = false;
  std::vector<std::string> memory_;
  std::vector<std::thread> threads_;
};

// oneTBB ends the program where a thread of its own cannot start.  Where they are at the limit, those of
// the library and what they take to work have to fit below it, too.
int startable_threads(int wanted) {
  static std::atomic<int> known{1};
  if (wanted <= known) return wanted;
  StartedThreads others;
  int threads = 1;
  while (threads < wanted && others.start_one()) ++threads;
  if (threads < wanted) return std::max(1, threads / 2);
  known = wanted;
  return threads;
}

struct Ticket {
  std::uint64_t unit;
  int slot;
};

// What a thread has written before it gives is there for one that takes after it.  oneTBB sees to that,
// too, but in a library where a sanitizer of threads sees nothing.
class Handover {
 public:
  void give() { given_.fetch_add(1, std::memory_order_release); }
  void take() const { static_cast<void>(given_.load(std::memory_order_acquire)); }

 private:
  std::atomic<std::uint32_t> given_{0};
};

// Of one thread that goes on with what others have left, and leaves it to others.
class Turn {
 public:
  explicit Turn(Handover& handover) : handover_(handover) { handover.take(); }
  ~Turn() { handover_.give(); }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  Handover& handover_;
};

}  // namespace

Run::Run(const Session& session)
    : session_(session),
      threads_(startable_threads(session.threads > 0 ? session.threads : available_threads())),
      kind_(time_kind_of(session.budget)),
      begun_(session.begun ? *session.begun : session.clock->now()) {}

void Run::report(const ProgressReport& progress) {
  constexpr double between_reports = 0.1;  // s
  if (!session_.report) return;
  const double now = seconds();
  if (now - last_report_ < between_reports) return;
  last_report_ = now;
  session_.report(progress);
}

int slots_of(const Run& run) { return run.threads() + 2; }

void run_in_order(const Run& run, const Units& units) {
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(run.threads()));
  tbb::task_arena arena(run.threads());
  tbb::concurrent_bounded_queue<int> free_slots;
  for (int slot = 0; slot < slots_of(run); ++slot) free_slots.push(slot);
  Handover begun, taken, merged;
  std::vector<Handover> of_slot(static_cast<std::size_t>(slots_of(run)));
  std::uint64_t next = 0;
  const auto take = [&](tbb::flow_control& flow) -> Ticket {
    begun.take();
    const Turn turn(taken);
    if (next == units.units || !units.more(next)) {
      flow.stop();
      return {};
    }
    Ticket ticket{next++, 0};
    free_slots.pop(ticket.slot);
    return ticket;
  };
  const auto work = [&](Ticket ticket) {
    begun.take();
    const Turn turn(of_slot[static_cast<std::size_t>(ticket.slot)]);
    units.work(ticket.unit, ticket.slot);
    return ticket;
  };
  const auto merge = [&](Ticket ticket) {
    {
      const Turn turn(merged), own(of_slot[static_cast<std::size_t>(ticket.slot)]);
      units.merge(ticket.unit, ticket.slot);
    }
    free_slots.push(ticket.slot);
  };
  begun.give();
  arena.execute([&] {
    tbb::parallel_pipeline(
        static_cast<std::size_t>(slots_of(run)),
        tbb::make_filter<void, Ticket>(tbb::filter_mode::serial_in_order, take) &
            tbb::make_filter<Ticket, Ticket>(tbb::filter_mode::parallel, work) &
            tbb::make_filter<Ticket, void>(tbb::filter_mode::serial_in_order, merge));
  });
  taken.take();
  merged.take();
}

void run_parallel(const Run& run, int count, const std::function<void(int)>& work) {
  run_within(run, [&] {
    in_parallel(static_cast<std::size_t>(count), [&](std::size_t i) { work(static_cast<int>(i)); });
  });
}

void in_parallel(std::size_t count, const std::function<void(std::size_t)>& work) {
  Handover begun, done;
  begun.give();
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, count, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        begun.take();
        for (std::size_t i = range.begin(); i != range.end(); ++i) work(i);
        done.give();
      },
      tbb::simple_partitioner());
  done.take();
}

void run_within(const Run& run, const std::function<void()>& work) {
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                            static_cast<std::size_t>(run.threads()));
  tbb::task_arena arena(run.threads());
  arena.execute(work);
}

}  // namespace wander
