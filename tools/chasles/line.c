/* line.c - see line.h. */
#define _DEFAULT_SOURCE /* baud rates above 38400 */
#include "line.h"

#include <errno.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "text.h"

enum { CONNECT_MS = 5000, END_MS = 500, STEP_MS = 10, LONGEST_HOST = 255 };

static bool make_nonblocking(int file) { return fcntl(file, F_SETFL, fcntl(file, F_GETFL) | O_NONBLOCK) == 0; }

static bool cannot_open(const struct line *line, const char *reason) {
  complain("cannot open the device %s: %s", line->name, reason);
  return false;
}

/* The program of exec:, a process group of its own, for the signal handler. */
static volatile sig_atomic_t group;

/* Whoever stops this program stops the device with it. */
static void stop_both(int number) {
  if (group > 0) kill(-(pid_t)group, SIGKILL);
  signal(number, SIG_DFL);
  raise(number);
}

/* The child's ends of the pipes become its standard input and output. Both sides close what is not theirs. */
static bool open_program(struct line *line, const char *command) {
  int to[2];
  int from[2];
  if (pipe(to) != 0) return cannot_open(line, strerror(errno));
  if (pipe(from) != 0) {
    const int reason = errno;
    close(to[0]);
    close(to[1]);
    return cannot_open(line, strerror(reason));
  }
  line->child = fork();
  if (line->child == 0) {
    setpgid(0, 0);
    dup2(to[0], STDIN_FILENO);
    dup2(from[1], STDOUT_FILENO);
    close(to[0]);
    close(to[1]);
    close(from[0]);
    close(from[1]);
    signal(SIGPIPE, SIG_DFL);
    execl("/bin/sh", "sh", "-c", command, (char *)NULL);
    _exit(127);
  }
  const int reason = errno;
  close(to[0]);
  close(from[1]);
  line->in = from[0];
  line->out = to[1];
  if (line->child < 0) {
    close(line->in);
    close(line->out);
    return cannot_open(line, strerror(reason));
  }
  setpgid(line->child, line->child); /* here too, whoever comes first */
  group = (sig_atomic_t)line->child;
  signal(SIGINT, stop_both);
  signal(SIGTERM, stop_both);
  return true;
}

/* Connects within CONNECT_MS; errno tells why not. */
static bool connect_within(int socket, const struct addrinfo *address) {
  if (!make_nonblocking(socket)) return false;
  if (connect(socket, address->ai_addr, address->ai_addrlen) == 0) return true;
  if (errno != EINPROGRESS) return false;
  struct pollfd ready = {socket, POLLOUT, 0};
  socklen_t size = sizeof errno;
  int reason = ETIMEDOUT;
  if (poll(&ready, 1, CONNECT_MS) > 0) getsockopt(socket, SOL_SOCKET, SO_ERROR, &reason, &size);
  errno = reason;
  return reason == 0;
}

/* HOST:PORT; an address in numbers may hold colons itself. */
static bool open_tcp(struct line *line, const char *address) {
  char host[LONGEST_HOST + 1];
  const char *colon = strrchr(address, ':');
  if (colon == NULL || colon == address || colon[1] == '\0' || colon - address > LONGEST_HOST) {
    return cannot_open(line, "expected tcp:HOST:PORT");
  }
  memcpy(host, address, (size_t)(colon - address));
  host[colon - address] = '\0';
  struct addrinfo wanted;
  struct addrinfo *found = NULL;
  memset(&wanted, 0, sizeof wanted);
  wanted.ai_socktype = SOCK_STREAM;
  const int failure = getaddrinfo(host, colon + 1, &wanted, &found);
  if (failure != 0) return cannot_open(line, gai_strerror(failure));
  int file = -1;
  for (const struct addrinfo *each = found; each != NULL && file < 0; each = each->ai_next) {
    file = socket(each->ai_family, each->ai_socktype, each->ai_protocol);
    if (file < 0 || connect_within(file, each)) continue;
    const int reason = errno;
    close(file);
    file = -1;
    errno = reason;
  }
  freeaddrinfo(found);
  if (file < 0) return cannot_open(line, strerror(errno));
  const int yes = 1;
  setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  line->in = line->out = file;
  return true;
}

static bool baud_constant(long baud, speed_t *speed) {
  static const struct {
    long baud;
    speed_t speed;
  } rates[] = {
    {9600, B9600},
    {19200, B19200},
    {38400, B38400},
    {57600, B57600},
    {115200, B115200},
    {230400, B230400},
#if defined(B460800) && defined(B921600)
    {460800, B460800},
    {921600, B921600},
#endif
  };
  for (size_t i = 0; i < sizeof rates / sizeof rates[0]; ++i) {
    if (rates[i].baud != baud) continue;
    *speed = rates[i].speed;
    return true;
  }
  return false;
}

/* Eight bits, no parity, one stop bit, no handshake, nothing translated. */
static bool make_raw(int file, speed_t speed) {
  struct termios settings;
  if (tcgetattr(file, &settings) != 0) return false;
  settings.c_iflag = IGNBRK;
  settings.c_oflag = 0;
  settings.c_lflag = 0;
  settings.c_cflag = CS8 | CREAD | CLOCAL;
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  if (cfsetispeed(&settings, speed) != 0 || cfsetospeed(&settings, speed) != 0) return false;
  return tcsetattr(file, TCSANOW, &settings) == 0 && tcflush(file, TCIOFLUSH) == 0;
}

static bool open_serial(struct line *line, const char *name) {
  char path[LONGEST_HOST + 1];
  const size_t length = strcspn(name, ":");
  long baud = 115200;
  speed_t speed = B115200;
  if (length > LONGEST_HOST) return cannot_open(line, "the name is too long");
  memcpy(path, name, length);
  path[length] = '\0';
  if (name[length] == ':' && (!parse_integer(name + length + 1, 1, 10000000, &baud) || !baud_constant(baud, &speed))) {
    return cannot_open(line, "not one of the usual baud rates");
  }
  const int file = open(path, O_RDWR | O_NOCTTY | O_NONBLOCK);
  if (file < 0) return cannot_open(line, strerror(errno));
  if (!make_raw(file, speed)) {
    const int reason = errno;
    close(file);
    return cannot_open(line, strerror(reason));
  }
  line->in = line->out = file;
  return true;
}

bool line_open(struct line *line, const char *name) {
  bool opened = false;
  line->name = name;
  line->child = 0;
  signal(SIGPIPE, SIG_IGN); /* a device that ends is an error to report, not the end of this program */
  if (strncmp(name, "exec:", 5) == 0) {
    opened = open_program(line, name + 5);
  } else if (strncmp(name, "tcp:", 4) == 0) {
    opened = open_tcp(line, name + 4);
  } else if (name[0] == '/') {
    opened = open_serial(line, name);
  } else {
    return cannot_open(line, "expected tcp:HOST:PORT, exec:COMMAND or /dev/NAME[:BAUD]");
  }
  return opened && make_nonblocking(line->in) && make_nonblocking(line->out);
}

int line_exchange(struct line *line, struct pending *pending, char *bytes, size_t space, int milliseconds) {
  for (;;) {
    struct pollfd ready[2] = {{line->in, POLLIN, 0}, {line->out, POLLOUT, 0}};
    const int count = poll(ready, pending->count > 0 ? 2 : 1, milliseconds);
    if (count == 0) return 0;
    if (count < 0 && errno != EINTR) return -1;
    if (count < 0) continue;
    if (ready[0].revents != 0) {
      const ssize_t got = read(line->in, bytes, space);
      if (got > 0) return (int)got;
      if (got == 0 || (errno != EAGAIN && errno != EINTR)) return -1;
    }
    if (ready[1].revents != 0) {
      const ssize_t sent = write(line->out, pending->bytes, pending->count);
      if (sent < 0 && errno != EAGAIN && errno != EINTR) return -1;
      if (sent > 0) {
        pending->bytes += sent;
        pending->count -= (size_t)sent;
      }
    }
  }
}

/* Waits for the child's end for so long; the exit status as waitpid gives it. */
static bool wait_for(pid_t child, int milliseconds, int *status) {
  const struct timespec step = {0, STEP_MS * 1000000L};
  for (int waited = 0; waited <= milliseconds; waited += STEP_MS) {
    if (waitpid(child, status, WNOHANG) == child) return true;
    nanosleep(&step, NULL);
  }
  return false;
}

void line_close(struct line *line, char ending[LINE_ENDING]) {
  int status = 0;
  strcpy(ending, "closed the line");
  if (line->out != line->in) close(line->out);
  close(line->in);
  if (line->child <= 0) return;
  if (!wait_for(line->child, END_MS, &status)) {
    kill(-line->child, SIGTERM);
    if (!wait_for(line->child, END_MS, &status)) {
      kill(-line->child, SIGKILL);
      waitpid(line->child, &status, 0);
    }
  } else if (WIFEXITED(status)) {
    snprintf(ending, LINE_ENDING, "ended with exit status %d", WEXITSTATUS(status));
  } else if (WIFSIGNALED(status)) {
    snprintf(ending, LINE_ENDING, "was ended by signal %d", WTERMSIG(status));
  }
  group = 0;
}

time_t seconds_now(void) {
  struct timespec now = {0};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec;
}
