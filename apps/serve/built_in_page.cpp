#include "apps/serve/lab_page.h"

namespace cromer::core::serve {

#ifdef CROMER_BUILT_IN_PAGE
std::string_view built_in_page() {
  static constexpr char bytes[] = {
#embed CROMER_BUILT_IN_PAGE
  };
  return {bytes, sizeof bytes};
}
#else
std::string_view built_in_page() { return {}; }
#endif

}  // namespace cromer::core::serve
