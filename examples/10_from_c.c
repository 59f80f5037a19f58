/* The same from C, as other languages call it: JSON and arrays in, JSON and arrays out. */
#include <cromer/c.h>
#include <stdio.h>

int main(void) {
  const char* request =
      "{\"mass\": 1, \"stiffness\": 9, \"damping\": 0.2, \"method\": [\"euler-cromer\", \"exact\"], "
      "\"step\": 0.01, \"until\": \"50 s\"}";
  cromer_result* result = cromer_call("simulate", request, NULL, 0, NULL, NULL);
  size_t count = 0;
  const cromer_array* arrays = cromer_arrays(result, &count);
  for (size_t i = 0; i < count; ++i)
    printf("%-9s %zu numbers, the last %g\n", arrays[i].name, arrays[i].length,
           arrays[i].values[arrays[i].length - 1]);
  const int status = cromer_status(result);
  if (status != CROMER_DONE) fputs(cromer_document(result), stderr);
  cromer_free(result);
  return status;
}
