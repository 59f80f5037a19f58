// The JSON of a recording in progress, which the page reads.
#include "cromer/documents/json/live.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cromer/documents/words/words.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(LiveJson, SamplesAreAListForEachColumn) {
  SampleRows rows;
  rows.width = 2;
  rows.add(0.5, std::vector<double>{1, 10});
  rows.add(0.75, std::vector<double>{2, std::nan("")});
  EXPECT_EQ(live_samples_json(7, rows),
            "{\"first\":7,\"t\":[0.5,0.75],\"values\":[[1.0,2.0],[10.0,null]]}\n");
}

TEST(LiveJson, NoticesHaveTheirKind) {
  const Notice what{"nothing_came", {{"duration", 2.0}, {"time", 1.0}}};
  for (const auto& [kind, name] : {std::pair{RemarkKind::garbage, "garbage"},
                                   {RemarkKind::clock, "clock"},
                                   {RemarkKind::gap, "gap"},
                                   {RemarkKind::connection, "connection"},
                                   {RemarkKind::device, "device"},
                                   {RemarkKind::option, "option"}})
    EXPECT_EQ(live_notices_json(std::vector<Remark>{{kind, what}}),
              "{\"notices\":[{\"kind\":\"" + std::string(name) +
                  "\",\"text\":\"nothing for 2 s from 1 s on\",\"german\":\"2 s lang nichts, ab 1 s\"}]}\n");
}

TEST(LiveJson, TheStatusHasTheTimesAndWhyItEnded) {
  RecorderStatus status{.running = true,
                        .samples = 3,
                        .begin = 0.5,
                        .end = 2.5,
                        .rate = 1,
                        .last = {0.25},
                        .garbage = 4,
                        .notices = 2};
  const std::string counts =
      "\"running\":true,\"samples\":3,\"from\":0.5,\"to\":2.5,\"duration\":2.0,\"rate\":1.0,";
  EXPECT_EQ(live_status_json("", std::nullopt, "", status, {"x (m)"}),
            "{\"source\":null,\"for\":null,\"recording\":null," + counts +
                "\"times\":null,\"last\":[0.25],\"garbage\":4,\"columns\":[\"x (m)\"]}\n");
  status.times.by = TimesBy::device;
  EXPECT_EQ(live_status_json("serial:/dev/x", 60, "a.csv", status, {"x (m)"}),
            "{\"source\":\"serial:/dev/x\",\"for\":60.0,\"recording\":\"a.csv\"," + counts +
                "\"times\":{\"by\":\"device\"},\"last\":[0.25],\"garbage\":4,\"columns\":[\"x (m)\"]}\n");
  status.times = {.by = TimesBy::rate, .by_rate = 2, .by_arrival = 1, .rate = 100, .longest_delay = 0.25};
  status.rate = 0;
  status.failure = Notice{"stopped_while_starting"};
  EXPECT_EQ(
      live_status_json("", 60, "a.csv", status, {}),
      "{\"source\":null,\"for\":60.0,\"recording\":\"a.csv\",\"running\":true,\"samples\":3,\"from\":0.5,"
      "\"to\":2.5,\"duration\":2.0,\"rate\":null,\"times\":{\"by\":\"rate\",\"rate\":100.0,"
      "\"longest_delay\":0.25,\"by_rate\":2,\"by_arrival\":1},\"last\":[0.25],\"garbage\":4,\"columns\":[],"
      "\"message\":\"" +
          in_words(status.failure) + "\",\"message_german\":\"" +
          in_words(status.failure, {Language::german}) + "\"}\n");
}

TEST(LiveJson, AFitThatIsNotThereYetSaysWhy) {
  FittedRecording fitted;
  fitted.series.column = "x (m)";
  fitted.fit.status = FitStatus::no_oscillation;
  fitted.fit.message = Notice{"too_noisy", {{"percent", 12.46}}};
  const std::string why =
      "\"message\":\"too noisy: a sinusoid accounts for only 12.5 % of the "
      "variance\",\"message_german\":\"zu viel "
      "Rauschen: eine Sinusschwingung erklärt nur 12,5 % der Varianz\"}\n";
  const std::string begins = "{\"column\":\"x (m)\",\"status\":\"no_oscillation\",";
  EXPECT_EQ(live_fit_json(fitted), begins + "\"samples\":0," + why);
  fitted.series.t = {0.5, 0.75};
  EXPECT_EQ(live_fit_json(fitted), begins + "\"samples\":2,\"from\":0.5,\"to\":0.75," + why);
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
