// A library to load before the program (LD_PRELOAD): counts its calls that change a folder, and has one of them, or all
// from one on, fail.  What it does is said by the environment:
//
//   FAULTS_FOLDER   only calls on what is below it count (an absolute path)
//   FAULTS_LOG      a file to which it adds "struck CALL" when it strikes, and "calls N" when the program ends
//   FAULTS_AT       which call is struck, from 1; 0: none
//   FAULTS_HOW      once: it fails; stay: and so do all later ones that take space; short: half of it is written;
//                   signal: the program is sent FAULTS_NUMBER before it; deny: nothing can be made in the folder
//   FAULTS_NUMBER   of the error or signal
//   FAULTS_THREADS  so many beside the first can be there at one time; unset: all
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

enum how { HOW_NOTHING, HOW_ONCE, HOW_STAY, HOW_SHORT, HOW_SIGNAL, HOW_DENY };
enum space { TAKES_NONE, TAKES_SPACE };

static char folder[PATH_MAX];
static size_t folder_length;
static enum how how;
static long strike_at, most_threads = -1;
static int number;
static atomic_long calls, threads;
static atomic_int has_struck;

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static long long_of(const char* variable) {
  const char* text = getenv(variable);
  return text ? atol(text) : 0;
}

// Opened for each line, so that no descriptor of the program's is taken.
static void note(const char* what, const char* word) {
  char line[128];
  const int length = snprintf(line, sizeof line, "%s %s\n", what, word);
  const char* log = getenv("FAULTS_LOG");
  if (!log) return;
  const int saved = errno;
  const int file =
      (int)syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666);
  if (file >= 0) {
    syscall(SYS_write, file, line, length);
    syscall(SYS_close, file);
  }
  errno = saved;
}

__attribute__((constructor)) static void begin(void) {
  static const char* const words[] = {"", "once", "stay", "short", "signal", "deny"};
  const char *place = getenv("FAULTS_FOLDER"), *wanted = getenv("FAULTS_HOW");
  snprintf(folder, sizeof folder, "%s", place ? place : "");
  folder_length = strlen(folder);
  strike_at = long_of("FAULTS_AT");
  if (getenv("FAULTS_THREADS")) most_threads = long_of("FAULTS_THREADS");
  number = (int)long_of("FAULTS_NUMBER");
  for (int i = HOW_ONCE; wanted && i <= HOW_DENY; ++i)
    if (strcmp(wanted, words[i]) == 0) how = (enum how)i;
}

__attribute__((destructor)) static void end(void) {
  char count[32];
  snprintf(count, sizeof count, "%ld", atomic_load(&calls));
  note("calls", count);
}

static int is_inside(const char* path) {
  return folder_length > 0 && strncmp(path, folder, folder_length) == 0 &&
         (path[folder_length] == '/' || path[folder_length] == 0);
}

static int is_open_inside(int file) {
  char link[64], path[PATH_MAX];
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const int saved = errno;
  const ssize_t length = readlink(link, path, sizeof path - 1);
  errno = saved;
  if (length < 0) return 0;
  path[length] = 0;
  return is_inside(path);
}

static int is_path_inside(int directory, const char* path) {
  if (!path) return 0;
  if (path[0] == '/') return is_inside(path);
  if (directory != AT_FDCWD) return is_open_inside(directory);
  char here[PATH_MAX];
  return getcwd(here, sizeof here) && is_inside(here);
}

// Counts a call; what is to become of it.
static enum how fate(const char* call, enum space space) {
  if (how == HOW_DENY) {
    note("struck", call);
    return HOW_ONCE;
  }
  const long mine = atomic_fetch_add(&calls, 1) + 1;
  if (how == HOW_STAY && atomic_load(&has_struck) && space == TAKES_SPACE) return HOW_ONCE;
  if (mine != strike_at) return HOW_NOTHING;
  atomic_store(&has_struck, 1);
  note("struck", call);
  if (how == HOW_SIGNAL) {
    kill(getpid(), number);
    return HOW_NOTHING;
  }
  return how == HOW_STAY ? HOW_ONCE : how;
}

static int fails(const char* call, enum space space, int is_meant) {
  if (!is_meant) return 0;
  const enum how what = fate(call, space);
  if (what != HOW_ONCE) return 0;
  errno = number;
  return 1;
}

static int makes(int flags) {
  return (flags & (O_CREAT | O_TRUNC)) != 0 || (flags & O_ACCMODE) != O_RDONLY;
}

#define OPENS(name, directory, head, ...)                                                       \
  int name head {                                                                               \
    va_list rest;                                                                               \
    va_start(rest, flags);                                                                      \
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0;               \
    va_end(rest);                                                                               \
    if (fails("open", TAKES_SPACE, makes(flags) && is_path_inside(directory, path))) return -1; \
    return REAL(name)(__VA_ARGS__, flags, mode);                                                \
  }
OPENS(open, AT_FDCWD, (const char* path, int flags, ...), path)
OPENS(open64, AT_FDCWD, (const char* path, int flags, ...), path)
OPENS(openat, at, (int at, const char* path, int flags, ...), at, path)
OPENS(openat64, at, (int at, const char* path, int flags, ...), at, path)

int creat(const char* path, mode_t mode) { return open(path, O_CREAT | O_WRONLY | O_TRUNC, mode); }

#define OPENS_STREAM(name)                                                     \
  FILE* name(const char* path, const char* mode) {                             \
    if (fails("fopen", TAKES_SPACE,                                            \
              strpbrk(mode, "wa+") != NULL && is_path_inside(AT_FDCWD, path))) \
      return NULL;                                                             \
    return REAL(name)(path, mode);                                             \
  }
OPENS_STREAM(fopen)
OPENS_STREAM(fopen64)

ssize_t write(int file, const void* bytes, size_t size) {
  if (is_open_inside(file)) {
    const enum how what = fate("write", TAKES_SPACE);
    if (what == HOW_ONCE) {
      errno = number;
      return -1;
    }
    if (what == HOW_SHORT && size > 1) size /= 2;
  }
  return REAL(write)(file, bytes, size);
}

#define WRITES(name, head, ...)                                     \
  ssize_t name head {                                               \
    if (fails(#name, TAKES_SPACE, is_open_inside(file))) return -1; \
    return REAL(name)(__VA_ARGS__);                                 \
  }
WRITES(pwrite, (int file, const void* bytes, size_t size, off_t at), file, bytes, size, at)
WRITES(pwrite64, (int file, const void* bytes, size_t size, off64_t at), file, bytes, size, at)
WRITES(writev, (int file, const struct iovec* parts, int count), file, parts, count)

#define CALLS(name, space, meant, head, ...)   \
  int name head {                              \
    if (fails(#name, space, meant)) return -1; \
    return REAL(name)(__VA_ARGS__);            \
  }
CALLS(ftruncate, TAKES_SPACE, is_open_inside(file), (int file, off_t size), file, size)
CALLS(ftruncate64, TAKES_SPACE, is_open_inside(file), (int file, off64_t size), file, size)
CALLS(fsync, TAKES_SPACE, is_open_inside(file), (int file), file)
CALLS(fdatasync, TAKES_SPACE, is_open_inside(file), (int file), file)
CALLS(rename, TAKES_NONE, is_path_inside(AT_FDCWD, to), (const char* from, const char* to), from,
      to)
CALLS(renameat, TAKES_NONE, is_path_inside(d, to), (int c, const char* from, int d, const char* to),
      c, from, d, to)
CALLS(link, TAKES_SPACE, is_path_inside(AT_FDCWD, to), (const char* from, const char* to), from, to)
CALLS(mkdir, TAKES_SPACE, is_path_inside(AT_FDCWD, path), (const char* path, mode_t mode), path,
      mode)
CALLS(mkdirat, TAKES_SPACE, is_path_inside(d, path), (int d, const char* path, mode_t mode), d,
      path, mode)

char* mkdtemp(char* path) {
  if (fails("mkdtemp", TAKES_SPACE, is_path_inside(AT_FDCWD, path))) return NULL;
  return REAL(mkdtemp)(path);
}

// The descriptor is gone even where the call fails.
int close(int file) {
  const int flags = fcntl(file, F_GETFL);
  const int is_meant =
      how != HOW_DENY && flags >= 0 && (flags & O_ACCMODE) != O_RDONLY && is_open_inside(file);
  const int is_failing = fails("close", TAKES_NONE, is_meant);
  const int result = REAL(close)(file);
  if (!is_failing) return result;
  errno = number;
  return -1;
}

// Of one who may do all, as root may, the system would not say so.
int access(const char* path, int wanted) {
  if (how == HOW_DENY && (wanted & W_OK) && is_path_inside(AT_FDCWD, path)) {
    note("struck", "access");
    errno = number;
    return -1;
  }
  return REAL(access)(path, wanted);
}

struct start {
  void* (*work)(void*);
  void* argument;
};

static void* run_counted(void* given) {
  const struct start start = *(struct start*)given;
  free(given);
  void* result = start.work(start.argument);
  atomic_fetch_sub(&threads, 1);
  return result;
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                   void* argument) {
  if (most_threads < 0) return REAL(pthread_create)(thread, attributes, work, argument);
  if (atomic_fetch_add(&threads, 1) >= most_threads) {
    atomic_fetch_sub(&threads, 1);
    note("struck", "pthread_create");
    return EAGAIN;
  }
  struct start* start = malloc(sizeof *start);
  *start = (struct start){work, argument};
  return REAL(pthread_create)(thread, attributes, run_counted, start);
}
