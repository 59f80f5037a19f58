// Whether this is built for the page in the browser, which must be small.
#pragma once

namespace cromer::core {

#ifdef CROMER_PAGE
inline constexpr bool for_page = true;
#else
inline constexpr bool for_page = false;
#endif

}  // namespace cromer::core
