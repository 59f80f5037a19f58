#include "cromer/tasks/methods/unused_by_method.h"

namespace cromer::core {

bool uses_tolerance(std::string_view method) {
  return find_method(method)->is_adaptive() || visit_method(method, {}, [](const auto& of_name) {
           return requires { of_name.newton; };
         });
}

}  // namespace cromer::core
