#include <cromer/cromer.h>

#include <string>
#include <string_view>
#include <vector>

std::vector<double> t, x;  // a recording
int complain(std::string_view message, std::string_view argument = "");
void note(std::string_view);

int reader() {
  // here
  return 0;
}
