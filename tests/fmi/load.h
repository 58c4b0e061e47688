/* Loads a shared library on Linux and on Windows. */
#ifndef LOAD_H
#define LOAD_H

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef _WIN32
#include <windows.h>

static void *open_library(const char *path)
{
    void *library = (void *)LoadLibraryA(path);
    if (library == NULL) fprintf(stderr, "%s: error %lu\n", path, GetLastError());
    return library;
}

static void *find_function(void *library, const char *name)
{
    FARPROC function = GetProcAddress((HMODULE)library, name);
    void *address;
    memcpy(&address, &function, sizeof address);
    return address;
}
#else
#include <dlfcn.h>

static void *open_library(const char *path)
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) fprintf(stderr, "%s\n", dlerror());
    return library;
}

static void *find_function(void *library, const char *name) { return dlsym(library, name); }
#endif

/* Fills a table of pointers named as the functions. */
#define LOAD(name)                                                    \
    do {                                                              \
        void *address = find_function(library, #name);                \
        if (address == NULL) {                                        \
            fprintf(stderr, "%s is not exported\n", #name);           \
            exit(1);                                                  \
        }                                                             \
        memcpy(&fmu.name, &address, sizeof address);                  \
    } while (0);

#endif
