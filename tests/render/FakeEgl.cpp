// SPDX-License-Identifier: MIT
#include "FakeEgl.h"

#include <cstring>

using boxreel::FakeDevice;

namespace
{

boxreel::FakeEgl g_egl;

// A display and a context are the address of their device.
FakeDevice& DeviceOf(void* display)
{
    return *static_cast<FakeDevice*>(display);
}

void* GetPlatformDisplay(unsigned platform, void* device, const int*)
{
    constexpr unsigned kSurfaceless = 0x31DD;
    return platform == kSurfaceless ? &g_egl.surfaceless : device;
}

unsigned QueryDevices(int maximum, void** devices, int* count)
{
    *count = 0;
    while (*count < maximum && *count < g_egl.deviceCount)
    {
        devices[*count] = &g_egl.devices[*count];
        ++*count;
    }
    return 1;
}

const char* QueryDeviceString(void* device, int)
{
    return DeviceOf(device).abilities;
}

const char* GetString(unsigned)
{
    return g_egl.current ? g_egl.current->renderer : nullptr;
}

} // namespace

extern "C" {

boxreel::FakeEgl* GetFakeEgl()
{
    return &g_egl;
}

void* eglGetProcAddress(const char* name)
{
    const auto is = [name](const char* other) { return std::strcmp(name, other) == 0; };
    return is("eglGetPlatformDisplayEXT")  ? reinterpret_cast<void*>(GetPlatformDisplay)
           : is("eglQueryDevicesEXT")      ? reinterpret_cast<void*>(QueryDevices)
           : is("eglQueryDeviceStringEXT") ? reinterpret_cast<void*>(QueryDeviceString)
           : is("glGetString")             ? reinterpret_cast<void*>(GetString)
                                           : nullptr;
}

const char* eglQueryString(void*, int)
{
    return g_egl.extensions;
}

int eglGetError()
{
    return 0x3009;
}

unsigned eglBindAPI(unsigned)
{
    return 1;
}

unsigned eglInitialize(void* display, int*, int*)
{
    ++DeviceOf(display).started;
    return DeviceOf(display).starts;
}

void* eglCreateContext(void* display, void*, void*, const int*)
{
    FakeDevice& device = DeviceOf(display);
    device.contexts += device.makesContexts;
    return device.makesContexts ? display : nullptr;
}

unsigned eglDestroyContext(void*, void* context)
{
    --DeviceOf(context).contexts;
    return 1;
}

unsigned eglMakeCurrent(void* display, void*, void*, void* context)
{
    if (context != nullptr && !DeviceOf(display).bindsWithoutSurface)
    {
        return 0;
    }
    g_egl.current = static_cast<const FakeDevice*>(context);
    return 1;
}

void* eglGetCurrentContext()
{
    return const_cast<FakeDevice*>(g_egl.current);
}

} // extern "C"
