// What the next byte of a WebAssembly module is: an instruction, which operand of which one, or a byte of
// another section.
//
// A. Rossberg (ed.), "WebAssembly Core Specification 2.0", W3C, 2022, chapter 5.
#pragma once

#include <cstdint>

namespace cromer::pack {

/// What a byte within a function's code is part of.
enum class Part : std::uint8_t {
  instruction,
  block_type,
  label,
  function,
  type,
  local,
  global,
  alignment,
  offset,
  int32,
  int64,
  float32,
  float64,
  byte,
  labels,
  more_instruction,
  sixteen_bytes
};

class ModuleWalk {
 public:
  void take(std::uint8_t byte) {
    recent_ = recent_ << 8 | byte;
    const bool letter = (byte | 32) - 97u < 26 || byte - 48u < 10;
    word_ = letter ? (word_ + byte) * 0x2c1b3c6du : 0;
    if (heading_left_ > 0)
      --heading_left_;
    else if (level_ <= Level::other)
      take_of_section(byte);
    else
      take_of_code(byte);
  }

  bool in_code() const { return level_ == Level::code; }
  Part part() const { return part_; }
  int section() const { return section_; }
  /// Bytes of this operand that are known.
  unsigned place() const { return place_; }
  /// Their value.
  std::uint32_t operand() const { return operand_; }
  /// Instructions, the last in the lowest byte: the last four, and four before them.
  std::uint32_t instructions() const { return static_cast<std::uint32_t>(instructions_); }
  std::uint32_t older_instructions() const { return static_cast<std::uint32_t>(instructions_ >> 32); }
  std::uint32_t last_local() const { return last_local_; }
  std::uint32_t last_call() const { return last_call_; }
  /// How many functions have begun.
  std::uint32_t function() const { return function_; }
  /// The letters and figures since the last other byte, as one number.
  std::uint32_t word() const { return word_; }
  /// Bytes, the last in the lowest.
  std::uint64_t recent() const { return recent_; }

 private:
  enum class Level : std::uint8_t {
    section,
    section_size,
    other,
    functions,
    size,
    groups,
    count,
    group,
    code
  };

  /// Seven bits of a number; true at its end.
  bool number(std::uint8_t byte) {
    if (shift_ == 0) number_ = 0;
    number_ |= static_cast<std::uint32_t>(byte & 127) << shift_;
    shift_ = byte < 128 ? 0 : shift_ + 7;
    return shift_ == 0;
  }

  void take_of_section(std::uint8_t byte) {
    if (level_ == Level::section) {
      section_ = byte;
      level_ = Level::section_size;
    } else if (level_ == Level::section_size) {
      if (!number(byte)) return;
      section_left_ = number_;
      level_ = section_left_ == 0         ? Level::section
               : section_ == code_section ? Level::functions
                                          : Level::other;
    } else if (--section_left_ == 0) {
      level_ = Level::section;
    }
  }

  void take_of_code(std::uint8_t byte) {
    --section_left_;
    --function_left_;
    switch (level_) {
      case Level::functions:
        if (number(byte)) level_ = Level::size;
        break;
      case Level::size:
        if (!number(byte)) break;
        function_left_ = number_;
        level_ = Level::groups;
        ++function_;
        break;
      case Level::groups:
        if (number(byte)) begin_group(number_);
        break;
      case Level::count:
        if (byte < 128) level_ = Level::group;
        break;
      case Level::group:
        begin_group(groups_ - 1);
        break;
      default:
        take_code(byte);
        if (function_left_ == 0) level_ = section_left_ > 0 ? Level::size : Level::section;
    }
  }

  /// Of local variables.
  void begin_group(std::uint32_t groups) {
    groups_ = groups;
    level_ = groups > 0 ? Level::count : Level::code;
    if (groups > 0) return;
    instructions_ = last_local_ = 0;
    next_part(Part::instruction);
  }

  void take_code(std::uint8_t byte) {
    if (part_ == Part::instruction) {
      begin_instruction(byte);
      return;
    }
    if (fixed_ > 0) {
      if (place_ < 4) operand_ |= static_cast<std::uint32_t>(byte) << 8 * place_;
      if (++place_ == fixed_) end_operand();
    } else {
      if (place_ < 5) operand_ |= static_cast<std::uint32_t>(byte & 127) << 7 * place_;
      ++place_;
      if (byte < 128) end_operand();
    }
  }

  void begin_instruction(std::uint8_t code) {
    instructions_ = instructions_ << 8 | code;
    waiting_ = Part::instruction;
    Part next = Part::instruction;
    if (code >= 0x02 && code <= 0x04) next = Part::block_type;
    if (code == 0x0c || code == 0x0d) next = Part::label;
    if (code == 0x0e) next = Part::labels;
    if (code == 0x10) next = Part::function;
    if (code == 0x11) next = Part::type, waiting_ = Part::byte;
    if (code >= 0x20 && code <= 0x22) next = Part::local;
    if (code == 0x23 || code == 0x24) next = Part::global;
    if (code >= 0x28 && code <= 0x3e) next = Part::alignment, waiting_ = Part::offset;
    if (code == 0x3f || code == 0x40) next = Part::byte;
    if (code >= 0x41 && code <= 0x44) next = static_cast<Part>(static_cast<int>(Part::int32) + code - 0x41);
    if (code >= 0xfc) next = Part::more_instruction;
    next_part(next);
  }

  /// Of the instructions with two codes: 0xfc copies memory, 0xfd is for vectors.
  void begin_second(std::uint32_t code) {
    const bool vector = (instructions_ & 0xff) == 0xfd;
    instructions_ = instructions_ << 8 | (code & 0xff);
    Part next = Part::instruction;
    if (!vector) {
      if (code == 10) next = waiting_ = Part::byte;
      if (code == 11) next = Part::byte;
    } else {
      if (code < 12 || (code >= 84 && code <= 93)) next = Part::alignment, waiting_ = Part::offset;
      if (code == 12 || code == 13) next = Part::sixteen_bytes;
      if (code >= 21 && code <= 34) next = Part::byte;
      lane_follows_ = code >= 84 && code <= 91;
    }
    next_part(next);
  }

  void end_operand() {
    const Part ended = part_;
    if (ended == Part::local) last_local_ = operand_;
    if (ended == Part::function) last_call_ = operand_;
    if (ended == Part::more_instruction) return begin_second(operand_);
    if (ended == Part::labels) labels_ = operand_ + 1;
    if (ended == Part::labels || (ended == Part::label && labels_ > 0 && --labels_ > 0))
      return next_part(Part::label);
    const Part next = waiting_;
    waiting_ = Part::instruction;
    if (ended == Part::offset && lane_follows_) {
      lane_follows_ = false;
      return next_part(Part::byte);
    }
    next_part(next);
  }

  void next_part(Part part) {
    part_ = part;
    place_ = operand_ = 0;
    fixed_ = part == Part::float32         ? 4
             : part == Part::float64       ? 8
             : part == Part::sixteen_bytes ? 16
             : part == Part::byte          ? 1
                                           : 0;
  }

  static constexpr int code_section = 10;

  Level level_ = Level::section;
  int heading_left_ = 8;
  int section_ = 0;
  std::uint32_t section_left_ = 0, function_left_ = 0, groups_ = 0, labels_ = 0;
  std::uint32_t number_ = 0, shift_ = 0;
  Part part_ = Part::instruction, waiting_ = Part::instruction;
  bool lane_follows_ = false;
  std::uint32_t place_ = 0, operand_ = 0, fixed_ = 0;
  std::uint64_t instructions_ = 0, recent_ = 0;
  std::uint32_t last_local_ = 0, last_call_ = 0, function_ = 0, word_ = 0;
};

}  // namespace cromer::pack
