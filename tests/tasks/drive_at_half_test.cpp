// A drive whose frequency divides the body's own: the swing at first is no harmonic of it, for it dies down.
#include <gtest/gtest.h>

#include <cmath>

#include "cromer/base/number.h"
#include "cromer/model/sensor.h"
#include "cromer/tasks/fit/fit.h"
#include "tests/tasks/of_bytes.h"

namespace cromer::core {
namespace CROMER_FILE {

TEST(DriveAtHalf, IsSeen) {
  for (const double order : {2.0, 3.0})
    for (const double g : {0.025, 0.15}) {
      NormalDeviates noise(1);
      const double w0 = 5, w = w0 / order, own = std::sqrt(w0 * w0 - g * g);
      // From rest: the steady motion, and a swing that takes its place and speed away at first.
      const double gap = w0 * w0 - w * w, size = 0.3 / std::hypot(gap, 2 * g * w),
                   lag = std::atan2(2 * g * w, gap), x0 = size * std::cos(lag), v0 = size * w * std::sin(lag);
      std::string bytes = "Time (s),Position (m)\n";
      for (int i = 0; i < 3000; ++i) {
        const double t = 0.02 * i, steady = size * std::cos(w * t - lag),
                     swing = std::exp(-g * t) *
                             (x0 * std::cos(own * t) + (v0 + g * x0) / own * std::sin(own * t));
        bytes += shortest(t) + "," + shortest(steady - swing + 2e-4 * noise.next()) + "\n";
      }
      const auto fits = fit(*read_recording(bytes, "half.csv", {}), {});
      ASSERT_TRUE(fits.ok());
      const FittedRecording& found = fits->front();
      EXPECT_TRUE(found.says("motion_is_driven")) << order << ' ' << g;
      EXPECT_NEAR(found.fit.motion.angular_frequency(), w0, 0.02) << order << ' ' << g;
      EXPECT_NEAR(found.fit.motion.drive_frequency, w, 1e-3) << order << ' ' << g;
    }
}

}  // namespace CROMER_FILE
}  // namespace cromer::core
