// The program and the machine it runs on.
#pragma once

#include <cstddef>
#include <ctime>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace cromer::core::os {

/// To be called first in main: on Windows text is UTF-8 and bytes pass the standard streams as they are.
void prepare_streams();

/// The numbers of the standard streams.
constexpr int standard_input = 0, standard_output = 1, standard_error = 2;
bool is_terminal(int stream);
/// Of standard error; 0 where it is no terminal.
std::size_t terminal_width();
/// What is printed from now on goes nowhere.
void discard_standard_output();

/// Calls `handler` at the first Ctrl-C (or wish to terminate); the second ends the program.
void on_interrupt(void (*handler)());

/// The file of this program; empty where the system does not tell.
std::filesystem::path program();
/// [bytes]
double memory();
/// Gives freed memory back to the system, which the allocator would keep in pieces too small for what comes
/// next. Does nothing where the system has no such call.
void give_memory_back();
int processors();
std::string host_name();
/// So many open files as the system allows, at most `wanted`, which is asked for.
std::size_t files_at_most(std::size_t wanted);
/// The addresses (IPv4) by which others reach this machine.
std::vector<std::string> addresses();
/// Which nobody can guess.
void fill_randomly(std::span<unsigned char> bytes);
std::tm local_time(std::time_t time);
std::tm universal_time(std::time_t time);

}  // namespace cromer::core::os
