// What to save of a run: recorders, called with every state.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "cromer/base/function_ref.h"
#include "cromer/base/state.h"
#include "cromer/run/course.h"
#include "cromer/trajectory.h"

namespace cromer::core {

/// Any recorder of states in doubles, its type erased: for loops in which a call for each state costs
/// little.
using AnyRecorder = FunctionRef<void(double t, const State<double>& y)>;

/// Gives a recorder that works in blocks time to do so: between blocks of steps, out of the way of the fast
/// loop. To be called after at most `KeepEvery::most_between_pauses` states, and at the end.
template <class Recorder>
void pause(Recorder& record) {
  if constexpr (requires { record.pause(); }) record.pause();
}

/// Keeps the first and every n-th state after it. Memory is reserved once, at the start, and used piece by
/// piece, between blocks of steps, so that a run that ends early costs what it kept. Check
/// number_of_kept_states first. Or it hands every state to a function: one type does both, so that laws and
/// methods are compiled once.
class KeepEvery {
 public:
  static constexpr std::size_t most_between_pauses = 256;

  /// every > 0
  KeepEvery(long long every, Steps steps)
      : every_(every), most_(static_cast<std::size_t>(number_of_kept_states(steps, every))) {
    for (std::vector<double>* values : {&kept_.t, &kept_.x, &kept_.v}) values->reserve(most_);
    make_room();
  }

  /// The function outlives it; it sees all states, in order, some steps late.
  explicit KeepEvery(AnyRecorder each) : every_(1), most_(most_between_pauses), each_(each) { make_room(); }

  void operator()(double t, const State<double>& y) {
    if (--until_next_ > 0) return;
    until_next_ = every_;
    kept_.t[size_] = t;
    kept_.x[size_] = y.x;
    kept_.v[size_] = y.v;
    ++size_;
  }

  void pause() {
    if (!each_) return make_room();
    for (std::size_t i = 0; i < size_; ++i) (*each_)(kept_.t[i], {kept_.x[i], kept_.v[i]});
    size_ = 0;
  }

  /// Forgets the states but keeps the memory, for the next run of as many steps.
  void clear() {
    size_ = 0;
    until_next_ = 1;
  }

  /// The states so far; the recorder is then empty.
  Trajectory take() {
    resize(size_);
    size_ = 0;
    return std::move(kept_);
  }

 private:
  void make_room() {
    constexpr std::size_t piece = 1 << 15;
    if (size_ + most_between_pauses <= kept_.t.size() || kept_.t.size() == most_) return;
    resize(std::min(most_, kept_.t.size() + piece));
  }

  void resize(std::size_t size) {
    kept_.t.resize(size);
    kept_.x.resize(size);
    kept_.v.resize(size);
  }

  long long every_, until_next_ = 1;
  std::size_t most_;
  std::size_t size_ = 0;
  Trajectory kept_;
  std::optional<AnyRecorder> each_{};
};

/// Keeps nothing: the outcome has the final state.
struct KeepNone {
  template <class Real>
  void operator()(double, const State<Real>&) {}
};

}  // namespace cromer::core
