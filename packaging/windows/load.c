/* load FILE: loads cromer.dll and has it simulate and fit; 0 if both succeed. */
#include <stdio.h>
#include <windows.h>

#include <cromer/c.h>

int main(int count, char** words) {
  HMODULE library = count > 1 ? LoadLibraryA(words[1]) : NULL;
  if (!library) return printf("load: not loaded, error %lu\n", GetLastError()), 1;
  __typeof__(&cromer_call) call = (void*)GetProcAddress(library, "cromer_call");
  __typeof__(&cromer_status) status = (void*)GetProcAddress(library, "cromer_status");
  if (!call || !status) return printf("load: the door is not shown\n"), 1;
  const cromer_result* run = call(
      "simulate", "{\"stiffness\": 9, \"damping\": 0.2, \"position\": 1, \"method\": \"rk4\", \"step\": 0.01, \"until\": 50}", NULL, 0,
      NULL, NULL);
  const cromer_result* fit = call("fit", "{\"file\": \"data/Schwingung gr\xc3\xb6\xc3\x9f" "er.csv\", \"mass\": \"217.6 g\"}", NULL, 0, NULL, NULL);
  printf("load: simulate %d, fit %d\n", status(run), status(fit));
  return status(run) || status(fit);
}
