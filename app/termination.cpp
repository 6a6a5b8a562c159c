#include "app/termination.h"

#include "lessons/files/descriptor.h"

#include <QSocketNotifier>

#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace halfspace {
namespace {

constexpr std::array endings{SIGTERM, SIGINT, SIGHUP};

/// Two ends of a pipe. Nothing waits for room in it.
struct Pipe {
  static std::optional<Pipe> make(int flagsOfReader) {
    std::array<int, 2> ends{-1, -1};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0)
      return {};
    Pipe pipe{Descriptor(ends[0]), Descriptor(ends[1])};
    ::fcntl(pipe.reader.get(), F_SETFL, flagsOfReader);
    ::fcntl(pipe.writer.get(), F_SETFL, O_NONBLOCK);
    return pipe;
  }

  Descriptor reader;
  Descriptor writer;
};

/// Where the handler writes: all that it may do is little more than that.
volatile std::sig_atomic_t loopEnd = -1;
volatile std::sig_atomic_t threadEnd = -1;

extern "C" void noteSignal(int signal) {
  const int error = errno;
  const auto number = static_cast<unsigned char>(signal);
  static_cast<void>(!::write(loopEnd, &number, 1));
  static_cast<void>(!::write(threadEnd, &number, 1));
  errno = error;
}

} // namespace

class Termination::Impl {
public:
  Impl(End end, End endWhileBusy, int patience)
      : m_end(std::move(end)), m_endWhileBusy(std::move(endWhileBusy)), m_patience(patience),
        m_toLoop(Pipe::make(O_NONBLOCK)), m_toThread(Pipe::make(0)) {
    if (!m_toLoop || !m_toThread)
      return; // the signals then end the program as they do any other
    m_notifier = std::make_unique<QSocketNotifier>(m_toLoop->reader.get(), QSocketNotifier::Read);
    QObject::connect(m_notifier.get(), &QSocketNotifier::activated, m_notifier.get(),
                     [this] { takeInLoop(); });
    m_thread = std::thread([this] { watch(); });
    loopEnd = m_toLoop->writer.get();
    threadEnd = m_toThread->writer.get();
    for (std::size_t i = 0; i < endings.size(); ++i)
      if ((m_before[i] = std::signal(endings[i], noteSignal)) == SIG_IGN)
        std::signal(endings[i], SIG_IGN); // as nohup asks for
  }

  ~Impl() {
    if (!m_notifier)
      return;
    for (std::size_t i = 0; i < endings.size(); ++i)
      std::signal(endings[i], m_before[i]);
    {
      const std::scoped_lock held(m_mutex);
      m_isTaken = true;
    }
    m_taken.notify_one();
    m_toThread->writer.close();
    m_thread.join();
  }

  Impl(const Impl &) = delete;
  Impl &operator=(const Impl &) = delete;

private:
  void takeInLoop() {
    unsigned char number = 0;
    if (::read(m_toLoop->reader.get(), &number, 1) != 1)
      return;
    {
      const std::scoped_lock held(m_mutex);
      if (std::exchange(m_isTaken, true))
        return;
    }
    m_taken.notify_one();
    m_end(number);
  }

  /// In the thread: waits for a signal, and then for the event loop to take it.
  void watch() {
    unsigned char number = 0;
    if (const ReadPart part = readSome(m_toThread->reader.get(), reinterpret_cast<char *>(&number), 1);
        part.count != 1)
      return;
    std::unique_lock held(m_mutex);
    m_taken.wait_for(held, m_patience, [this] { return m_isTaken; });
    if (std::exchange(m_isTaken, true))
      return;
    held.unlock();
    m_endWhileBusy(number);
  }

  End m_end;
  End m_endWhileBusy;
  std::chrono::milliseconds m_patience;
  std::optional<Pipe> m_toLoop;
  std::optional<Pipe> m_toThread;
  std::unique_ptr<QSocketNotifier> m_notifier;
  std::array<void (*)(int), endings.size()> m_before{};

  std::mutex m_mutex;
  std::condition_variable m_taken;
  bool m_isTaken = false; ///< a signal, by the loop or by the thread
  std::thread m_thread;
};

Termination::Termination(End end, End endWhileBusy, int patience)
    : m_impl(std::make_unique<Impl>(std::move(end), std::move(endWhileBusy), patience)) {}
Termination::~Termination() = default;

} // namespace halfspace
