// Whether documents are well-formed, as expat reads them.
#pragma once

#include <expat.h>

#include <regex>
#include <string>

namespace cromer::core::test {

/// What a reader of XML complains of; "" where it does not.
inline std::string xml_fault(const std::string& document) {
  const XML_Parser parser = XML_ParserCreate("UTF-8");
  std::string fault;
  if (XML_Parse(parser, document.data(), static_cast<int>(document.size()), 1) == XML_STATUS_ERROR)
    fault = std::string(XML_ErrorString(XML_GetErrorCode(parser))) + " in line " +
            std::to_string(XML_GetCurrentLineNumber(parser)) + ", column " +
            std::to_string(XML_GetCurrentColumnNumber(parser));
  XML_ParserFree(parser);
  return fault;
}

/// The same of HTML as we write it: XML but for the elements that HTML has no end of.
inline std::string html_fault(const std::string& document) {
  static const std::regex without_end("<(meta|link|br|hr|img|wbr|col|input)\\b([^>]*[^/>])?>");
  return xml_fault(std::regex_replace(document, without_end, "<$1$2/>"));
}

}  // namespace cromer::core::test
