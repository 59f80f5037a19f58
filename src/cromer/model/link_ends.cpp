#include "cromer/model/link_ends.h"

#include <algorithm>

#include "cromer/base/wide.h"

namespace cromer::core {
namespace {

// Takes the forces of a band without damping off the accelerations of the masses from `from` to before `to`.
void pull_apart(const LinkBand& band, std::size_t from, std::size_t to, double* acceleration,
                const double* x) {
  if (from >= to) return;
  const double *own = x + from, *other = own + band.offset, *k = &band.stiffness[from - band.first];
  for_each_index(to - from,
                 [=, a = acceleration + from](std::size_t i) { a[i] = a[i] - k[i] * (own[i] - other[i]); });
}

// The same of two bands in one pass.
void pull_apart_by_both(const LinkBand& first, const LinkBand& second, std::size_t from, std::size_t to,
                        double* acceleration, const double* x) {
  if (from >= to) return;
  const double *own = x + from, *here = own + first.offset, *there = own + second.offset;
  const double *k = &first.stiffness[from - first.first], *l = &second.stiffness[from - second.first];
  for_each_index(to - from, [=, a = acceleration + from](std::size_t i) {
    a[i] = (a[i] - k[i] * (own[i] - here[i])) - l[i] * (own[i] - there[i]);
  });
}

// Takes the forces of any band off the accelerations of all its masses.
void pull(const LinkBand& band, double* acceleration, const double* x, const double* v) {
  const std::size_t size = band.stiffness.size();
  double* a = acceleration + band.first;
  const double *own = x + band.first, *speed = v + band.first;
  const double *k = band.stiffness.data(), *c = band.damping.empty() ? nullptr : band.damping.data();
  if (band.grounded) {
    if (c)
      for_each_index(size, [=](std::size_t i) { a[i] = (a[i] - c[i] * speed[i]) - k[i] * own[i]; });
    else
      for_each_index(size, [=](std::size_t i) { a[i] = a[i] - k[i] * own[i]; });
    return;
  }
  const double *other = own + band.offset, *other_speed = speed + band.offset;
  if (c)
    for_each_index(size, [=](std::size_t i) {
      a[i] = (a[i] - c[i] * (speed[i] - other_speed[i])) - k[i] * (own[i] - other[i]);
    });
  else
    pull_apart(band, band.first, band.end(), acceleration, x);
}

// Each band in pieces, without its long stretches of masses that have no such link.
std::vector<LinkBand> without_gaps(const std::vector<LinkBand>& bands) {
  constexpr std::size_t long_gap = 64;
  std::vector<LinkBand> result;
  for (const LinkBand& band : bands) {
    const auto empty = [&](std::size_t i) {
      return band.stiffness[i] == 0 && (band.damping.empty() || band.damping[i] == 0);
    };
    const std::size_t size = band.stiffness.size();
    for (std::size_t from = 0, to = 0, next = 0; from < size; from = next) {
      for (to = next = from; next < size && next - to < long_gap; ++next)
        if (!empty(next)) to = next + 1;
      while (next < size && empty(next)) ++next;
      if (to == from) continue;
      const auto part = [&](const std::vector<double>& all) {
        return all.empty() ? all : std::vector(all.begin() + from, all.begin() + to);
      };
      result.push_back(
          {band.grounded, band.offset, band.first + from, part(band.damping), part(band.stiffness)});
    }
  }
  return result;
}

}  // namespace

LinkEnds::LinkEnds(const Network& network) {
  const std::size_t count = network.masses.size();
  std::vector<std::vector<LinkEnd>> at(count);
  pattern_.masses = count;
  for (std::size_t i = 0; i < count; ++i) pattern_.places.push_back({i, i});
  const auto per_mass_of = [&](const NetworkLink& link, std::size_t mass) {
    Oscillator<double> law = link.law;
    law.mass = network.masses[mass].mass;
    return divided_by_mass(law);
  };
  const auto new_entry = [&](std::size_t row, std::size_t column) {
    pattern_.places.push_back({row, column});
    return pattern_.places.size() - 1;
  };

  for (std::size_t l = 0; l < network.links.size(); ++l) {
    const NetworkLink& link = network.links[l];
    const Law present = law_of(link.law).without(law_with<Friction>);
    const bool has_memory = present.has<Hysteresis>();
    resists_ = resists_ || has_memory || present.shares(terms_of_velocity);
    const std::size_t inner = has_memory ? inner_.size() : LinkEnd::none;
    if (has_memory) {
      const std::size_t of = link.to != ground ? link.to : link.from;
      inner_.push_back({l, link.from, link.to, per_mass_of(link, of), network.masses[of].mass});
      for (const std::size_t end : {link.from, link.to})
        if (end != ground) pattern_.inner_places.push_back({inner, end});
      pattern_.inner_places.push_back({inner, count + inner});
    }
    const auto add = [&](std::size_t mass, std::size_t other, double sign) {
      if (mass == ground) return;
      const Oscillator<double> law = per_mass_of(link, mass);
      LinkEnd end{.other = other, .sign = sign, .linear = Coefficients<linear_terms, double>(law)};
      if (!is_linear(present)) {
        end.general = general_.size();
        general_.emplace_back(law, present);
        end.resists_last = smallest_containing(compiled_laws, present).value_or(any_terms).has<Drag>();
      }
      if (other != ground) end.entry = new_entry(mass, other);
      if (has_memory) {
        end.inner = inner;
        end.inner_entry = new_entry(mass, count + inner);
        end.inner_share = inner_.back().mass / network.masses[mass].mass;
        end.resists_last = false;
      }
      at[mass].push_back(end);
    };
    add(link.from, link.to, -1);
    add(link.to, link.from, 1);
  }
  for (const std::vector<LinkEnd>& ends : at) {
    first_.push_back(ends_.size());
    ends_.insert(ends_.end(), ends.begin(), ends.end());
  }
  first_.push_back(ends_.size());
  pattern_.inner = inner_.size();
  solver_ = std::make_unique<SparseSolver>(pattern_);
  make_bands();
}

void LinkEnds::make_bands() {
  constexpr std::size_t most = 8;
  if (!general_.empty()) return;
  std::vector<LinkBand> bands;
  for (std::size_t i = 0; i < masses(); ++i)
    for (std::size_t e = first_[i]; e < first_[i + 1]; ++e) {
      const LinkEnd& end = ends_[e];
      const bool grounded = end.other == ground;
      const std::ptrdiff_t offset =
          grounded ? 0 : static_cast<std::ptrdiff_t>(end.other) - static_cast<std::ptrdiff_t>(i);
      // A second link between the same two is in a band of its own.
      auto band = std::find_if(bands.begin(), bands.end(), [&](const LinkBand& each) {
        return each.grounded == grounded && each.offset == offset && each.end() <= i;
      });
      if (band == bands.end()) {
        if (bands.size() == most) return;
        band = bands.insert(band, {.grounded = grounded, .offset = offset, .first = i});
      }
      band->stiffness.resize(i - band->first);
      band->damping.resize(i - band->first);
      band->stiffness.push_back(end.linear.of<Spring>());
      band->damping.push_back(end.linear.of<Viscous>());
    }
  for (LinkBand& band : bands)
    if (std::all_of(band.damping.begin(), band.damping.end(), [](double c) { return c == 0; }))
      band.damping.clear();
  bands_ = without_gaps(bands);
}

void LinkEnds::pull_by_bands(double* acceleration, const double* x, const double* v) const {
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const LinkBand& band = bands_[b];
    // A chain's masses feel both neighbours: where both are there, one pass takes both.
    if (b + 1 < bands_.size() && band.pulls_only_apart() && bands_[b + 1].pulls_only_apart()) {
      const LinkBand& next = bands_[++b];
      const std::size_t from = std::max(band.first, next.first),
                        to = std::max(from, std::min(band.end(), next.end()));
      for (const LinkBand* each : {&band, &next}) {
        pull_apart(*each, each->first, std::min(from, each->end()), acceleration, x);
        pull_apart(*each, std::max(to, each->first), each->end(), acceleration, x);
      }
      pull_apart_by_both(band, next, from, to, acceleration, x);
      continue;
    }
    pull(band, acceleration, x, v);
  }
}

}  // namespace cromer::core
