/* load FILE: loads cromer.dll and has it simulate and fit; 0 if both succeed. */
#include <stdio.h>
#include <windows.h>

#include <cromer/c.h>

int main(int count, char** words) {
  HMODULE library = count > 1 ? LoadLibraryA(words[1]) : NULL;
  if (!library) return printf("load: not loaded, error %lu\n", GetLastError()), 1;
  void* call = (void*)GetProcAddress(library, "cromer_call");
  void* status = (void*)GetProcAddress(library, "cromer_status");
  if (!call || !status) return printf("load: the door is not shown\n"), 1;
  cromer_result* run = ((cromer_result * (*)(const char*, const char*, const cromer_array*, size_t, cromer_progress, void*)) call)(
      "simulate", "{\"stiffness\": 9, \"damping\": 0.2, \"position\": 1, \"method\": \"rk4\", \"step\": 0.01, \"until\": 50}", NULL, 0,
      NULL, NULL);
  cromer_result* fit = ((cromer_result * (*)(const char*, const char*, const cromer_array*, size_t, cromer_progress, void*)) call)(
      "fit", "{\"file\": \"data/Schwingung gr\xc3\xb6\xc3\x9f" "er.csv\", \"mass\": \"217.6 g\"}", NULL, 0, NULL, NULL);
  const int run_status = ((int (*)(const cromer_result*))status)(run), fit_status = ((int (*)(const cromer_result*))status)(fit);
  printf("load: simulate %d, fit %d\n", run_status, fit_status);
  return run_status || fit_status;
}
