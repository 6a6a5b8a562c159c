#include "widgets/animation/video_encoder.h"

#include "lessons/files/write_file.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <QFile>
#include <QProcess>
#include <QStandardPaths>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace halfspace {
namespace {

constexpr const char *program = "ffmpeg";

/// In milliseconds: so often it is looked whether all was cancelled.
constexpr int betweenLooks = 20;

/// Of what ffmpeg says, the end is kept, in bytes: there it says why it gives up.
constexpr std::size_t mostKeptWords = 4096;

/// Pictures come as red, green, blue and alpha; what comes out has the colours that players expect of a
/// video, and neither dates nor versions.
QStringList argumentsFor(const EncodingRequest &request, const VideoCoding &coding,
                         const std::filesystem::path &file) {
  const QString size = QString("%1x%2").arg(request.size.width).arg(request.size.height);
  QStringList arguments{"-hide_banner", "-loglevel", "error",         "-xerror",
                        "-f",           "rawvideo",  "-pixel_format", "rgba"};
  arguments << "-video_size" << size << "-framerate" << QString::number(request.framesPerSecond);
  arguments << "-i"
            << "pipe:0";
  arguments << "-vf"
            << "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";
  arguments << "-colorspace"
            << "bt709"
            << "-color_primaries"
            << "bt709"
            << "-color_trc"
            << "bt709";
  arguments << "-color_range"
            << "tv" << coding.arguments;
  arguments << "-fflags"
            << "+bitexact"
            << "-flags:v"
            << "+bitexact"
            << "-f" << coding.container;
  // The file is there, empty; no part of its name is taken for a protocol.
  arguments << "-y"
            << "file:" + QFile::decodeName(file.c_str());
  return arguments;
}

/// The last line that has words.
std::string lastLineOf(const std::string &said) {
  const auto last = said.find_last_not_of("\r\n ");
  if (last == std::string::npos)
    return {};
  const auto before = said.rfind('\n', last);
  const auto begin = before == std::string::npos ? 0 : before + 1;
  return printable(said.substr(begin, last + 1 - begin));
}

class VideoEncoder : public Encoder {
public:
  VideoEncoder(const EncodingRequest &request, UnfinishedFile file)
      : m_request(request), m_file(std::move(file)) {}
  ~VideoEncoder() override {
    m_process.kill();
    m_process.waitForFinished(); // before its file is removed
  }

  [[nodiscard]] bool start(const QString &path, const VideoCoding &coding) {
    m_process.setStandardOutputFile(QProcess::nullDevice());
    m_process.start(path, argumentsFor(m_request, coding, m_file.path()), QIODevice::ReadWrite);
    return m_process.waitForStarted();
  }

  [[nodiscard]] std::optional<Problem> add(const RgbaImage &picture) override {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): devices take chars.
    m_process.write(reinterpret_cast<const char *>(picture.rgba.data()),
                    static_cast<qint64>(picture.rgba.size()));
    while (isRunning() && m_process.bytesToWrite() > 0 && !m_request.isCancelled()) {
      m_process.waitForBytesWritten(betweenLooks);
      listen();
    }
    return isRunning() ? std::nullopt : std::optional(failure());
  }

  [[nodiscard]] std::optional<Problem> finish() override {
    m_process.closeWriteChannel();
    while (isRunning() && !m_request.isCancelled()) {
      m_process.waitForFinished(betweenLooks);
      listen();
    }
    if (m_request.isCancelled())
      return Problem{};
    listen();
    return isWritten() ? m_file.finish() : std::optional(failure());
  }

private:
  [[nodiscard]] bool isRunning() const { return m_process.state() != QProcess::NotRunning; }

  /// On a full disk it has been seen to end as if all were well: it only says errors, so its silence counts.
  [[nodiscard]] bool isWritten() const {
    std::error_code error;
    return m_process.exitStatus() == QProcess::NormalExit && m_process.exitCode() == 0 && m_said.empty() &&
           std::filesystem::file_size(m_file.path(), error) > 0 && !error;
  }

  void listen() {
    m_said += m_process.readAllStandardError().toStdString();
    m_said.erase(0, m_said.size() - std::min(m_said.size(), mostKeptWords));
  }

  [[nodiscard]] Problem failure() {
    listen();
    const std::string reason = lastLineOf(m_said);
    return {reason.empty()
                ? words("ffmpeg ended before the video was written, and did not say why.")
                : words("ffmpeg could not write the video. It says: “{reason}”.", {{"reason", reason}}),
            m_request.file, 0, ""};
  }

  EncodingRequest m_request;
  UnfinishedFile m_file;
  std::string m_said;
  QProcess m_process; ///< ends before its file is removed
};

Result<std::unique_ptr<Encoder>> beginVideo(const std::string &name, const VideoCoding &coding,
                                            const EncodingRequest &request) {
  const auto [width, height] = request.size;
  if (coding.needsEvenSides && (width % 2 != 0 || height % 2 != 0))
    return Problem{
        words("{format} takes even numbers of pixels, not {width} × {height}.",
              {{"format", name}, {"width", std::to_string(width)}, {"height", std::to_string(height)}}),
        "", 0, ""};
  const QString path = QStandardPaths::findExecutable(program);
  if (path.isEmpty())
    return Problem{words("{format} is written by ffmpeg, which is not installed; on Debian: sudo apt install "
                         "ffmpeg. GIF and PNG need nothing else.",
                         {{"format", name}}),
                   "", 0, ""};
  auto file = UnfinishedFile::begin(request.file);
  if (!file)
    return file.problem();
  auto encoder = std::make_unique<VideoEncoder>(request, std::move(*file));
  if (!encoder->start(path, coding))
    return Problem{words("ffmpeg cannot be started: {file}", {{"file", path.toStdString()}}), "", 0, ""};
  return std::unique_ptr<Encoder>(std::move(encoder));
}

} // namespace

AnimationFormat videoFormat(const std::string &name, const std::string &ending, const VideoCoding &coding) {
  AnimationFormat format;
  format.name = name;
  format.ending = ending;
  format.begin = [name, coding](const EncodingRequest &request) { return beginVideo(name, coding, request); };
  return format;
}

} // namespace halfspace
