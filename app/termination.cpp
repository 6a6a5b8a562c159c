#include "app/termination.h"

#include "lessons/files/descriptor.h"

#include <QSocketNotifier>

#include <array>
#include <cerrno>
#include <csignal>

namespace halfspace {
namespace {

constexpr std::array endings{SIGTERM, SIGINT, SIGHUP};

/// Where the handler writes: all that it may do is little more than that.
volatile std::sig_atomic_t pipeEnd = -1;

extern "C" void noteSignal(int signal) {
  const int error = errno;
  const auto number = static_cast<unsigned char>(signal);
  static_cast<void>(!::write(pipeEnd, &number, 1));
  errno = error;
}

} // namespace

class Termination::Impl {
public:
  explicit Impl(std::function<void(int)> end) : m_end(std::move(end)) {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0)
      return; // the signals then end the program as they do any other
    m_read = Descriptor(ends[0]);
    m_write = Descriptor(ends[1]);
    m_notifier = std::make_unique<QSocketNotifier>(m_read.get(), QSocketNotifier::Read);
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, m_notifier.get(), [this] {
      unsigned char number = 0;
      if (::read(m_read.get(), &number, 1) == 1)
        m_end(number);
    });
    pipeEnd = m_write.get();
    for (std::size_t i = 0; i < endings.size(); ++i)
      if ((m_before[i] = std::signal(endings[i], noteSignal)) == SIG_IGN)
        std::signal(endings[i], SIG_IGN); // as nohup asks for
  }

  ~Impl() {
    if (!m_notifier)
      return;
    for (std::size_t i = 0; i < endings.size(); ++i)
      std::signal(endings[i], m_before[i]);
  }

  Impl(const Impl &) = delete;
  Impl &operator=(const Impl &) = delete;

private:
  std::function<void(int)> m_end;
  Descriptor m_read;
  Descriptor m_write;
  std::unique_ptr<QSocketNotifier> m_notifier;
  std::array<void (*)(int), endings.size()> m_before{};
};

Termination::Termination(std::function<void(int)> end) : m_impl(std::make_unique<Impl>(std::move(end))) {}
Termination::~Termination() = default;

} // namespace halfspace
