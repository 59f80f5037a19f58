// The functions that the module exports: bytes and numbers in its memory.
#include <cstdlib>
#include <string_view>

#include "answer.h"

namespace {

cromer::core::page::Answer& last() {
  static cromer::core::page::Answer answer;
  return answer;
}

}  // namespace

#define CROMER_EXPORT(name) extern "C" __attribute__((export_name(#name)))

CROMER_EXPORT(page_allocate) void* page_allocate(std::size_t bytes) { return std::malloc(bytes); }
CROMER_EXPORT(page_release) void page_release(void* bytes) { std::free(bytes); }

/// Returns the status. Text and numbers are valid until the next call.
CROMER_EXPORT(page_answer)
int page_answer(const char* request, std::size_t length, const char* file, std::size_t file_length) {
  last() = cromer::core::page::answer({request, length}, {file, file_length});
  return static_cast<int>(last().status);
}
CROMER_EXPORT(page_text) const char* page_text() { return last().text.data(); }
CROMER_EXPORT(page_text_length) std::size_t page_text_length() { return last().text.size(); }
CROMER_EXPORT(page_numbers) const double* page_numbers() { return last().numbers.data(); }
CROMER_EXPORT(page_numbers_length) std::size_t page_numbers_length() { return last().numbers.size(); }
