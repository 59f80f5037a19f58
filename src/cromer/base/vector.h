// Many numbers as one scalar, so that every method integrates many masses as it integrates one.
//
// The length is known at run time. Methods make a dozen short-lived vectors a step; their memory is kept in a
// list and used again, so that after its first step a run allocates nothing.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>

#include "cromer/base/bit_cast.h"
#include "cromer/base/dual.h"
#include "cromer/base/wide.h"

namespace cromer::core {

/// Pieces of memory that vectors of this thread have given back.
class VectorMemory {
 public:
  static double* take(std::size_t size) {
    Pieces& pieces = free_pieces();
    for (std::size_t i = pieces.count; i-- > 0;)
      if (pieces.piece[i].size == size) {
        double* numbers = pieces.piece[i].numbers.release();
        std::swap(pieces.piece[i], pieces.piece[--pieces.count]);
        return numbers;
      }
    return new double[size];
  }

  static void give_back(double* numbers, std::size_t size) {
    Pieces& pieces = free_pieces();
    // Pieces of a length that nobody asks for any more make room.
    Piece& place = pieces.count < pieces.piece.size() ? pieces.piece[pieces.count++]
                                                      : pieces.piece[pieces.next++ % pieces.piece.size()];
    place = {std::unique_ptr<double[]>(numbers), size};
  }

 private:
  struct Piece {
    std::unique_ptr<double[]> numbers{};
    std::size_t size = 0;
  };
  struct Pieces {
    std::array<Piece, 64> piece;
    std::size_t count = 0, next = 0;
  };
  static Pieces& free_pieces() {
    static thread_local Pieces pieces;
    return pieces;
  }
};

/// Real numbers, or one number that stands for all of them: a default one is 0, and has no size. Sums, and
/// products with numbers, go component by component. value_of is the largest magnitude.
class Vector {
 public:
  Vector() = default;
  template <class Number>
  requires std::is_arithmetic_v<Number> Vector(Number all)
      : number_(static_cast<double>(all)) {}  // NOLINT: as numbers do

  /// Of components that are not set yet.
  static Vector of_size(std::size_t size) {
    Vector made;
    made.size_ = size;
    if (size > 0) made.numbers_ = VectorMemory::take(size);
    return made;
  }

  static Vector zeros(std::size_t size) {
    Vector made = of_size(size);
    for_each_index(size, [to = made.numbers_](std::size_t i) { to[i] = 0; });
    return made;
  }

  Vector(const Vector& other) : size_(other.size_), number_(other.number_) {
    if (size_ == 0) return;
    numbers_ = VectorMemory::take(size_);
    copy(other);
  }
  Vector(Vector&& other) noexcept { swap(other); }
  Vector& operator=(const Vector& other) {
    if (size_ != other.size_ || size_ == 0) return *this = Vector(other);
    if (this != &other) copy(other);
    return *this;
  }
  Vector& operator=(Vector&& other) noexcept {
    swap(other);
    return *this;
  }
  ~Vector() {
    if (numbers_) VectorMemory::give_back(numbers_, size_);
  }

  /// 0 where one number stands for all.
  std::size_t size() const { return size_; }
  double operator[](std::size_t i) const { return size_ == 0 ? number_ : numbers_[i]; }
  /// Only of a vector with a size.
  double& operator[](std::size_t i) { return numbers_[i]; }
  const double* data() const { return numbers_; }
  double* data() { return numbers_; }

  Vector operator-() const { return times(-1, *this); }
  Vector& operator+=(const Vector& b) { return *this = sum(1, std::move(*this), 1, b); }
  Vector& operator-=(const Vector& b) { return *this = sum(1, std::move(*this), -1, b); }

  /// p a. Where `a` is about to go, its memory becomes the result's, here and below.
  template <class A>
  static Vector times(double p, A&& a) {
    if (a.size_ == 0) return p * a.number_;
    const double* from = a.numbers_;
    Vector result = room_of(std::forward<A>(a));
    for_each_index(result.size_, [=, to = result.numbers_](std::size_t i) { to[i] = p * from[i]; });
    return result;
  }

  /// a / c.
  template <class A>
  static Vector quotient(A&& a, double c) {
    if (a.size_ == 0) return a.number_ / c;
    const double* from = a.numbers_;
    Vector result = room_of(std::forward<A>(a));
    for_each_index(result.size_, [=, to = result.numbers_](std::size_t i) { to[i] = from[i] / c; });
    return result;
  }

  /// p a + q b. A factor of 1 or -1 rounds nothing.
  template <class A, class B>
  static Vector sum(double p, A&& a, double q, B&& b) {
    if (a.size_ == 0 && b.size_ == 0) return p * a.number_ + q * b.number_;
    if (b.size_ == 0) return sum_with_number(p, std::forward<A>(a), q * b.number_);
    if (a.size_ == 0) return sum_with_number(q, std::forward<B>(b), p * a.number_);
    const double *left = a.numbers_, *right = b.numbers_;
    Vector result = std::is_lvalue_reference_v<A> ? room_of(std::forward<B>(b)) : room_of(std::forward<A>(a));
    add(result.size_, p, left, q, right, result.numbers_);
    return result;
  }

 private:
  void swap(Vector& other) noexcept {
    std::swap(size_, other.size_);
    std::swap(number_, other.number_);
    std::swap(numbers_, other.numbers_);
  }
  template <class A>
  static Vector sum_with_number(double p, A&& a, double number) {
    const double* from = a.numbers_;
    Vector result = room_of(std::forward<A>(a));
    for_each_index(result.size_, [=, to = result.numbers_](std::size_t i) { to[i] = p * from[i] + number; });
    return result;
  }
  static void add(std::size_t size, double p, const double* a, double q, const double* b, double* to) {
    for_each_index(size, [=](std::size_t i) { to[i] = p * a[i] + q * b[i]; });
  }
  void copy(const Vector& other) {
    for_each_index(size_, [from = other.numbers_, to = numbers_](std::size_t i) { to[i] = from[i]; });
  }
  static Vector room_of(const Vector& a) { return of_size(a.size_); }
  static Vector room_of(Vector&& a) { return std::move(a); }

  std::size_t size_ = 0;
  double number_ = 0;
  double* numbers_ = nullptr;
};

template <class T>
concept IsVector = std::same_as<std::remove_cvref_t<T>, Vector>;

/// A number times a vector, not multiplied yet: the sum that takes it does so in the same pass. It owns a
/// vector that was a temporary; else it refers to one, which must outlive it.
template <class Held>
struct Scaled {
  using Value = Vector;

  double factor;
  Held vector;

  operator Vector() && { return Vector::times(factor, std::forward<Held>(vector)); }  // NOLINT: it is one
  operator Vector() const& { return Vector::times(factor, std::as_const(vector)); }   // NOLINT
};

template <class T>
inline constexpr bool is_scaled = false;
template <class Held>
inline constexpr bool is_scaled<Scaled<Held>> = true;

template <class T>
concept IsScaled = is_scaled<std::remove_cvref_t<T>>;
template <class T>
concept IsSummand = IsVector<T> || IsScaled<T>;

template <IsSummand A>
double factor_of(const A& a) {
  if constexpr (IsScaled<A>)
    return a.factor;
  else
    return 1;
}
template <IsSummand A>
decltype(auto) vector_of(A&& a) {
  if constexpr (IsScaled<A>)
    return (std::forward<A>(a).vector);
  else
    return (std::forward<A>(a));
}

template <IsSummand A, IsSummand B>
Vector operator+(A&& a, B&& b) {
  return Vector::sum(factor_of(a), vector_of(std::forward<A>(a)), factor_of(b),
                     vector_of(std::forward<B>(b)));
}
template <IsSummand A, IsSummand B>
Vector operator-(A&& a, B&& b) {
  return Vector::sum(factor_of(a), vector_of(std::forward<A>(a)), -factor_of(b),
                     vector_of(std::forward<B>(b)));
}
template <class Factor, IsVector A>
requires std::is_arithmetic_v<Factor>
auto operator*(Factor c, A&& a) { return Scaled<A>{static_cast<double>(c), std::forward<A>(a)}; }
template <class Factor, IsScaled A>
requires std::is_arithmetic_v<Factor>
auto operator*(Factor c, A&& a) { return c * Vector(std::forward<A>(a)); }
template <class Factor, IsSummand A>
requires std::is_arithmetic_v<Factor>
auto operator*(A&& a, Factor c) { return c * std::forward<A>(a); }
template <class Divisor, IsVector A>
requires std::is_arithmetic_v<Divisor> Vector operator/(A&& a, Divisor c) {
  return Vector::quotient(std::forward<A>(a), static_cast<double>(c));
}

/// Whether all components are finite. Exponents are tested as integers, several at a time.
inline bool all_finite(const Vector& a) {
  if (a.size() == 0) return std::isfinite(a[0]);
  struct Look {
    const double* numbers;
    std::uint64_t overflowed = 0;
    void operator()(std::size_t i) {
      constexpr std::uint64_t exponent = 0x7ff0000000000000, one = 0x0010000000000000;
      overflowed |= (bit_cast<std::uint64_t>(numbers[i]) & exponent) + one;
    }
  };
  return for_each_index(a.size(), Look{a.data()}).overflowed >> 63 == 0;
}

/// The number; of many the largest magnitude, and not a number where one of them is not.
inline double value_of(const Vector& a) {
  if (a.size() == 0) return a[0];
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double size = std::abs(a.data()[i]);
    if (!(size <= largest)) largest = size;
    if (std::isnan(largest)) return largest;
  }
  return largest;
}

}  // namespace cromer::core
