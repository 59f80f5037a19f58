// The page that cromer serve hands out.
#pragma once

#include <string>
#include <string_view>

namespace cromer::core::serve {

/// The file itself: beside the build (build/page) or installed (share/cromer); "" where neither is.
std::string find_lab_page();

/// The page that a released program carries; "" in others.
std::string_view built_in_page();

/// What is shown where the page has not been built.
std::string page_is_missing();

/// What is shown where the address lacks the token, or has another one; English and German.
std::string token_is_missing();

}  // namespace cromer::core::serve
