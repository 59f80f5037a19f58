#include "cromer/tasks/simulate/event_option.h"
#include "cromer/documents/words/words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cromer/tasks/simulate/simulate.h"

namespace cromer::core {
namespace {

using testing::HasSubstr;

TEST(EventOption, IsAThresholdADirectionAndAStop) {
  const Event event = *parse_event("position=1 cm:falling:stop");
  EXPECT_EQ(event.quantity, Event::Quantity::position);
  EXPECT_DOUBLE_EQ(event.value, 0.01);
  EXPECT_EQ(event.crossing, Crossing::falling);
  EXPECT_TRUE(event.stop);
  const Event turning = *parse_event("turning-point");
  EXPECT_EQ(turning.quantity, Event::Quantity::velocity);
  EXPECT_EQ(turning.value, 0);
  EXPECT_EQ(turning.crossing, Crossing::any);
  EXPECT_FALSE(turning.stop);
  EXPECT_EQ(parse_event("velocity=-0.2:rising")->value, -0.2);
}

TEST(EventOption, RefusesWhatItCannotWatch) {
  const auto refusal = [](const char* text) {
    const auto event = parse_event(text);
    return event.ok() ? std::string() : in_words(event.error());
  };
  EXPECT_THAT(refusal(""), HasSubstr("--event"));
  EXPECT_THAT(refusal("speed=1"), HasSubstr("\"speed\""));
  EXPECT_THAT(refusal("position"), HasSubstr("value is missing"));
  EXPECT_THAT(refusal("turning-point=0"), HasSubstr("no value"));
  EXPECT_THAT(refusal("position=1 kg"), HasSubstr("length"));
  EXPECT_THAT(refusal("position=1:up"), HasSubstr("\"up\""));
  EXPECT_THAT(refusal("position=1:rising:falling"), HasSubstr("only one"));
}

TEST(EventOption, ARunReportsItsEventsAndStopsWhenAsked) {
  const auto result = simulate({.stiffness = 9,
                                .method = {"exact", "dormand-prince", "rk4"},
                                .step = 0.01,
                                .until = 10,
                                .tolerance = 1e-12,
                                .event = {"position=0", "turning-point:rising:stop"}});
  ASSERT_TRUE(result.ok());
  EXPECT_TRUE(result->ok()) << "a stop that was asked for is a success";
  for (const SimulatedRun& run : result->runs) {
    EXPECT_EQ(run.outcome.status, Status::stopped_by_event);
    EXPECT_TRUE(run.message.empty());
    EXPECT_NEAR(run.outcome.t, 1.0471975511965976, 1e-7) << run.method;
    ASSERT_EQ(run.events.found.size(), 2u);
    EXPECT_EQ(run.events.found[0].event, 0u);
    EXPECT_EQ(run.trajectory.t.back(), run.outcome.t);
  }
}

TEST(EventOption, FrictionNeedsNoSmallerStaticFriction) {
  const auto refused = simulate({.law = {.friction = 0.2}, .static_friction = 0.1});
  ASSERT_FALSE(refused.ok());
  EXPECT_THAT(in_words(refused.error()),
              HasSubstr("--static-friction: it must be at least --friction (0.2 N)"));
  const auto held = simulate({.law = {.friction = 0.1}, .static_friction = 1.1, .method = {"rk4", "exact"}});
  ASSERT_TRUE(held.ok());
  for (const SimulatedRun& run : held->runs) EXPECT_EQ(run.outcome.y, (State<double>{1, 0}));
  const auto driven =
      simulate({.law = {.friction = 0.1}, .drive_amplitude = 1, .drive_frequency = {2}, .method = {"exact"}});
  ASSERT_FALSE(driven.ok());
  EXPECT_THAT(in_words(driven.error()), HasSubstr("friction"));
  EXPECT_THAT(in_words(driven.error()), HasSubstr("drive"));
}

}  // namespace
}  // namespace cromer::core
