#ifndef HANDLEBODY_STAGE_CLOCK_H
#define HANDLEBODY_STAGE_CLOCK_H

#include "interrupt.h"

#include <CGAL/Memory_sizer.h>

#include <ctime>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

// Measures CPU seconds (of all threads) and resident bytes of each stage, and says on a terminal which one runs.
class Stage_clock {
public:
  struct Stage {
    std::string name;
    double seconds;
    std::size_t bytes; // resident in memory at its end
  };

  explicit Stage_clock(bool quiet) : m_shows(!quiet && isatty(STDERR_FILENO)) {}
  ~Stage_clock() { finish(); }

  void start(const std::string& name) {
    finish();
    m_running = name;
    m_start = std::clock();
    if (m_shows) std::cerr << "\r\033[K" << name << " ..." << std::flush;
  }

  void advance(std::size_t done, std::size_t all) const {
    if (m_shows) std::cerr << "\r\033[K" << m_running << " ... " << done << " of " << all << std::flush;
  }

  void finish() {
    if (m_running.empty()) return;
    m_stages.push_back({m_running, double(std::clock() - m_start) / CLOCKS_PER_SEC, CGAL::Memory_sizer().resident_size()});
    m_running.clear();
    if (m_shows) std::cerr << "\r\033[K" << std::flush;
  }

  const std::vector<Stage>& stages() const { return m_stages; }

private:
  bool m_shows;
  std::string m_running;
  std::clock_t m_start = 0;
  std::vector<Stage> m_stages;
};

// Passes the stages of the library on to the clock, and Ctrl-C to the library.
class Clock_visitor {
public:
  // `prefix` is that of the names of stages.
  explicit Clock_visitor(Stage_clock& clock, std::string prefix = {}) : m_clock(&clock), m_prefix(std::move(prefix)) {
    Interrupt::watch();
  }

  bool start_stage(const char* name) {
    m_clock->start(m_prefix + name);
    return !Interrupt::is_requested();
  }
  bool advance(std::size_t done, std::size_t all) {
    m_clock->advance(done, all);
    return !Interrupt::is_requested();
  }

private:
  Stage_clock* m_clock;
  std::string m_prefix;
};

#endif // HANDLEBODY_STAGE_CLOCK_H
