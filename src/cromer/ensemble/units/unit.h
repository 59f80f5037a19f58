// The kernel for one instruction set: the loop over the steps of a group. Law and method are those of the
// scalar run, over packs.
//
// A unit defines CROMER_UNIT, its name, and CROMER_PACK_ARCH, its architecture in xsimd, and includes this
// first; its function is cromer_advance_NAME. The linker keeps one copy of an inline function that several
// units emit. If it kept that of a newer instruction set, an older machine would crash. So all code of a
// unit, xsimd's too, lies in namespaces of its own, and only plain numbers go in and out (group.h). A test
// looks through the symbols.
#define CROMER_JOINED(a, b) a##_##b
#define CROMER_JOIN(a, b) CROMER_JOINED(a, b)
#define cromer CROMER_JOIN(cromer_in, CROMER_UNIT)
#define xsimd CROMER_JOIN(xsimd_in, CROMER_UNIT)

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <tuple>
#include <type_traits>
#include <utility>

#include "cromer/analysis/energy.h"
#include "cromer/base/magnitude.h"
#include "cromer/base/state.h"
#include "cromer/ensemble/group.h"
#include "cromer/ensemble/pack.h"
#include "cromer/ensemble/stepped_force.h"
#include "cromer/methods/all.h"
#include "cromer/model/driven_oscillator.h"
#include "cromer/model/law_force.h"

namespace cromer::core {

/// Sums of one pack over the states it has left.
template <class Real, Law law>
struct PackSums {
  Real x = 0.0, c = 0.0, s = 0.0, cc = 0.0, cs = 0.0, ss = 0.0, xc = 0.0, xs = 0.0, xx = 0.0, energy = 0.0;

  void add(double weight, const Coefficients<law, Real>& per_mass, Law present, const State<Real>& y,
           const Real& cosine, const Real& sine) {
    const Real wx = weight * y.x, wc = weight * cosine, ws = weight * sine;
    x += wx;
    c += wc;
    s += ws;
    cc += wc * cosine;
    cs += wc * sine;
    ss += ws * sine;
    xc += wx * cosine;
    xs += wx * sine;
    xx += wx * y.x;
    energy += weight * cromer::core::energy<law>(Real(1.0), per_mass, present, y);
  }

  void add_to(cromer_group::Sums& sums, std::size_t first) const {
    const auto to = [&](cromer_group::Numbers& all, const Real& part) {
      (Real::load(all.of + first) + part).store(all.of + first);
    };
    to(sums.x, x), to(sums.c, c), to(sums.s, s);
    to(sums.cc, cc), to(sums.cs, cs), to(sums.ss, ss);
    to(sums.xc, xc), to(sums.xs, xs), to(sums.xx, xx), to(sums.energy, energy);
  }
};

/// The drive as the method asks for it.
template <class Real, class M>
struct DriveFor {
  using Type = SteppedForce<Real, M::info.divisions>;
  static Type of(const HarmonicForce<Real>& force, const Real& h, const M&) { return {force, h}; }
};
template <class Real, AsksAtFractions M>
struct DriveFor<Real, M> {
  using Type = RotatedForce<Real, M>;
  static Type of(const HarmonicForce<Real>& force, const Real& h, const M& method) {
    return {force, h, method};
  }
};
template <class Real>
struct NoDrive {
  using Type = NoSteppedForce;
  template <class... T>
  static Type of(const T&...) {
    return Type{};
  }
};

/// As many oscillators of a group as a Real has lanes, while they run. `measured`: sums are kept.
template <class Real, class M, Terms terms, bool measured>
struct Member {
  using Drive = std::conditional_t<terms.drive, DriveFor<Real, M>, NoDrive<Real>>;
  using Phasor = std::conditional_t<measured, SteppedPhasor<Real>, NoSteppedForce>;
  using System = DrivenOscillator<Real, terms, typename Drive::Type>;
  using Memory = typename M::template Memory<Real>;
  using Present = std::conditional_t<terms.law == any_terms, Law, NoLaw>;
  struct NoSums {};

  Real h;
  Coefficients<terms.law, Real> law;  // per unit mass
  [[no_unique_address]] Present present;
  System system;
  Phasor phasor;
  Real x, v, peak;
  Truth<Real> converged;
  Memory memory;
  std::conditional_t<measured, PackSums<Real, terms.law>, NoSums> sums{};

  /// Those from `first` on.
  [[gnu::always_inline]] static Member from(const cromer_group::Group& group, std::size_t first,
                                            const M& method) {
    const auto load = [&](const cromer_group::Numbers& numbers) { return Real::load(numbers.of + first); };
    const Real step = load(group.step);
    const HarmonicForce<Real> drive{load(group.drive_amplitude), load(group.drive_frequency),
                                    load(group.drive_phase)};
    Coefficients<terms.law, Real> per_mass;
    for_each_term([&]<class T>() {
      if constexpr (Coefficients<terms.law, Real>::terms.template has<T>())
        per_mass.template of<T>() = load(group.coefficients[place_of_term<T>]);
    });
    Present present{};
    if constexpr (terms.law == any_terms) present = Law{group.law};
    Member m{.h = step,
             .law = per_mass,
             .present = present,
             .system = System(per_mass, Drive::of(drive, step, method), present),
             .phasor = Phasor(drive, step),
             .x = load(group.x),
             .v = load(group.v),
             .peak = load(group.peak),
             .converged = load(group.failed) <= 0.0,
             .memory = {}};
    if (group.steps == 0) {
      const DrivenOscillator<Real, terms> at_any_time(per_mass, drive, present);
      m.memory = method.start(at_any_time, Real(0.0), State<Real>{m.x, m.v});
    } else if constexpr (!std::is_empty_v<Memory>) {
      std::array<Real, carried> numbers;
      for (std::size_t i = 0; i < carried; ++i) numbers[i] = load(group.memory[i]);
      std::memcpy(static_cast<void*>(&m.memory), numbers.data(), sizeof m.memory);
    }
    return m;
  }

  void to(cromer_group::Group& group, std::size_t first) const {
    const auto store = [&](const Real& from, cromer_group::Numbers& numbers) {
      from.store(numbers.of + first);
    };
    store(x, group.x), store(v, group.v), store(peak, group.peak);
    store(choose(converged, Real(0.0), Real(1.0)), group.failed);
    if constexpr (!std::is_empty_v<Memory>) {
      std::array<Real, carried> numbers;
      std::memcpy(static_cast<void*>(numbers.data()), &memory, sizeof memory);
      for (std::size_t i = 0; i < carried; ++i) store(numbers[i], group.memory[i]);
    }
    if constexpr (measured) sums.add_to(group.sums, first);
  }

  /// Makes the drive exact for the step after n steps.
  [[gnu::always_inline]] void anchor(double n) {
    const Real t = n * h;
    if constexpr (terms.drive) system.force().anchor(t);
    if constexpr (measured) phasor.anchor(t);
  }

  /// Makes it ready for the next.
  [[gnu::always_inline]] void move_on() {
    if constexpr (terms.drive) system.force().move_on();
    if constexpr (measured) phasor.move_on();
  }

  /// The step after n steps.
  [[gnu::always_inline]] void step(const M& method, double n, [[maybe_unused]] double weight) {
    if constexpr (measured) {
      sums.add(weight, law, present, {x, v}, phasor.cosine, phasor.sine);
    }
    const State<Real> y{x, v};
    const auto trial = method.step(system, StepTime<Real>{n * h}, StepTime<Real>{h, 1}, y, memory);
    x = trial.y.x;
    v = trial.y.v;
    if constexpr (!std::is_empty_v<Memory>) converged = converged && trial.converged;
    peak = larger(peak, abs(x));
    move_on();
  }

 private:
  static constexpr std::size_t carried = std::is_empty_v<Memory> ? 0 : sizeof(Memory) / sizeof(Real);
  static_assert(carried <= std::extent_v<decltype(cromer_group::Group::memory)>);
};

/// Steps between two exact cosines of a drive.
inline constexpr long long steps_between_anchors = 128;

/// Calls f with each member, without a loop: only then does the compiler keep them in registers, not in an
/// array in memory.
template <class Members, class F>
[[gnu::always_inline]] inline void for_each_member(Members& members, const F& f) {
  std::apply(
      [&](auto&... member) __attribute__((always_inline)) { (f(member), ...); }, members);
}

/// `count` packs side by side, so that each has something to do while others wait for their last operation.
/// A function of its own for each law: inlined into one, they grow so large that steps stay calls.
template <std::size_t count, class Real, class M, Terms terms, bool measured>
[[gnu::noinline]] void advance_members(cromer_group::Group& group, std::size_t first, const M& method,
                                       const cromer_group::Order& order) {
  using One = Member<Real, M, terms, measured>;
  auto members = [&]<std::size_t... i>(std::index_sequence<i...>) __attribute__((always_inline)) {
    return std::array{One::from(group, first + i * Real::size, method)...};
  }
  (std::make_index_sequence<count>{});
  const M by = method;
  const auto begun = static_cast<long long>(group.steps);
  for (long long n = 0; n < order.steps;) {
    // Anchors lie at the same steps however a run is cut into orders.
    const long long since = (begun + n) % steps_between_anchors;
    const auto anchor = static_cast<double>(begun + n - since);
    for_each_member(
        members, [&](auto& member) __attribute__((always_inline)) { member.anchor(anchor); });
    for (long long i = 0; i < since; ++i)
      for_each_member(
          members, [](auto& member) __attribute__((always_inline)) { member.move_on(); });
    const long long last = std::min(order.steps, n + steps_between_anchors - since);
    for (; n < last; ++n) {
      const auto taken = static_cast<double>(begun + n);
      const double weight = measured ? order.weights[n] : 1;
      for_each_member(
          members, [&](auto& member) __attribute__((always_inline)) { member.step(by, taken, weight); });
    }
  }
  std::size_t place = first;
  for_each_member(
      members, [&](const auto& member) __attribute__((always_inline)) {
        member.to(group, place);
        place += Real::size;
      });
}

/// side_by_side: how many packs are stepped together, as many as registers hold.
/// kernel_laws: the laws with code of their own in the kernel, which every unit compiles for every method and
/// drive: a measured choice. All other laws share the code of any_terms.
/// The sanitizers take one of each: the whole would take ten minutes to compile.
#ifdef CROMER_SANITIZED
inline constexpr std::size_t side_by_side = 1;
inline constexpr Law kernel_laws[] = {law_of("viscous+drag+cubic")};
#else
inline constexpr std::size_t side_by_side = 4;
inline constexpr Law kernel_laws[] = {law_of("viscous"), law_of("viscous+cubic"),
                                      law_of("viscous+drag+cubic")};
#endif

/// All packs of the group, `side_by_side` at a time.
template <class Real, class M, Terms terms, bool measured>
void advance_all(cromer_group::Group& group, const M& method, const cromer_group::Order& order) {
  constexpr std::size_t packs = cromer_group::size / Real::size;
  // The general law has much to do for each pack, and its code would be four times as long.
  // A step of an implicit method fills the registers sooner.
  constexpr std::size_t at_most = M::info.implicit ? std::min<std::size_t>(2, side_by_side) : side_by_side;
  constexpr std::size_t together = terms.law == any_terms ? 1 : std::min(packs, at_most);
  for (std::size_t first = 0; first < cromer_group::size; first += together * Real::size)
    advance_members<together, Real, M, terms, measured>(group, first, method, order);
}

/// With the terms that the group has. The general law is always compiled with a drive, which may be 0, and so
/// is what keeps sums: they are those of driven motions.
template <class Real, class M, bool measured>
void advance_with_terms(cromer_group::Group& group, const M& method, const cromer_group::Order& order) {
  const auto by_law = [&]<Law law>() {
    if (!law.contains(Law{group.law})) return false;
    if constexpr (!measured)
      if (!group.driven) {
        advance_all<Real, M, Terms{.drive = false, .law = law}, measured>(group, method, order);
        return true;
      }
    advance_all<Real, M, Terms{.drive = true, .law = law}, measured>(group, method, order);
    return true;
  };
  const bool known = [&]<std::size_t... i>(std::index_sequence<i...>) {
    return (by_law.template operator()<kernel_laws[i]>() || ...);
  }
  (std::make_index_sequence<std::size(kernel_laws)>{});
  if (!known) advance_all<Real, M, Terms{.drive = true, .law = any_terms}, measured>(group, method, order);
  group.steps += static_cast<double>(order.steps);
  group.lanes = Real::size;
}

/// By the method at that place of the list; false if it has no formula of fixed steps.
template <class Real, std::size_t place>
bool advance_by(cromer_group::Group& group, const cromer_group::Order& order,
                const MethodSettings& settings) {
  using M = std::tuple_element_t<place, AllMethods>;
  if constexpr (M::info.takes_fixed_steps()) {
    const M method = make_method<M>(settings);
    order.weights ? advance_with_terms<Real, M, true>(group, method, order)
                  : advance_with_terms<Real, M, false>(group, method, order);
    return true;
  } else {
    return false;
  }
}

}  // namespace cromer::core

extern "C" bool CROMER_JOIN(cromer_advance, CROMER_UNIT)(cromer_group::Group& group,
                                                         const cromer_group::Order& order) {
  using namespace cromer::core;
  const MethodSettings settings{.newton = {.tolerance = order.tolerance},
                                .beta = order.beta,
                                .gamma = order.gamma,
                                .rho_inf = order.rho_inf};
  return [&]<std::size_t... place>(std::index_sequence<place...>) {
    return ((order.method == place && advance_by<Pack<CROMER_PACK_ARCH>, place>(group, order, settings)) ||
            ...);
  }
  (std::make_index_sequence<std::tuple_size_v<AllMethods>>{});
}
