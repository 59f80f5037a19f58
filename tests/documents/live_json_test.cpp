// The JSON of a recording in progress, which the page reads.
#include "cromer/documents/json/live.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cromer::core {
namespace {

TEST(LiveJson, SamplesAreAListForEachColumn) {
  SampleRows rows;
  rows.width = 2;
  rows.add(0.5, std::vector<double>{1, 10});
  rows.add(0.75, std::vector<double>{2, std::nan("")});
  EXPECT_EQ(live_samples_json(7, rows),
            "{\"first\":7,\"t\":[0.5,0.75],\"values\":[[1.0,2.0],[10.0,null]]}\n");
}

TEST(LiveJson, NoticesHaveTheirKind) {
  const std::vector<Remark> remarks{
      {RemarkKind::gap, Notice{"nothing_came", {{"duration", 2.0}, {"time", 1.0}}}}};
  EXPECT_EQ(live_notices_json(remarks),
            "{\"notices\":[{\"kind\":\"gap\",\"text\":\"nothing for 2 s from 1 s on\","
            "\"german\":\"2 s lang nichts, ab 1 s\"}]}\n");
}

}  // namespace
}  // namespace cromer::core
