#ifndef HANDLEBODY_INTERRUPT_H
#define HANDLEBODY_INTERRUPT_H

#include <csignal>
#include <initializer_list>

// Ctrl-C, and SIGTERM as `timeout` sends it, ask to stop at the next step; a second one stops at once. What a script ignores
// in the background, as shells do with Ctrl-C, is ignored.
class Interrupt {
public:
  static void watch() {
    for (int signal : {SIGINT, SIGTERM})
      if (std::signal(signal, remember) == SIG_IGN) std::signal(signal, SIG_IGN);
  }
  static bool is_requested() { return s_is_requested != 0; }

private:
  static void remember(int signal) {
    s_is_requested = 1;
    std::signal(signal, SIG_DFL);
  }

  static inline volatile std::sig_atomic_t s_is_requested = 0;
};

#endif // HANDLEBODY_INTERRUPT_H
