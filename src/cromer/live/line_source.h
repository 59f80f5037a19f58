// A source of lines over one descriptor: serial line, TCP connection, standard input.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cromer/live/source.h"
#include "cromer/os/line.h"

namespace cromer::core {

class LineSource final : public Source {
 public:
  using Connect = std::function<Result<Descriptor>()>;

  /// `connect` opens the input, and again after its end if it `comes_back`. `within_line`: the first bytes
  /// may be in the middle of a line, as on a serial line.
  LineSource(std::string name, Connect connect, bool comes_back, bool within_line, const LineSettings& lines)
      : name_(std::move(name)),
        connect_(std::move(connect)),
        comes_back_(comes_back),
        reader_(lines, within_line) {}

  Result<void> open() override;
  bool receive(double seconds, SampleRows& rows, std::vector<Remark>& notices) override;
  void finish(SampleRows& rows, std::vector<Remark>& notices) override { reader_.release_all(rows, notices); }
  const Headings& headings() const override { return reader_.headings(); }
  SampleTimes times() const override { return reader_.times(); }
  double pace() const override { return reader_.pace(); }

 private:
  bool come_back(double seconds, std::vector<Remark>& notices);
  bool read(double seconds, SampleRows& rows, std::vector<Remark>& notices);

  std::string name_;
  Connect connect_;
  bool comes_back_;
  LineReader reader_;
  Descriptor line_;
  double lost_at_ = 0;  // [s]
};

}  // namespace cromer::core
