// Objects.h - a GL object with an owner.
#pragma once
#include "Device.h"

namespace fbrdf::gl {

enum class ObjectKind { buffer, texture, vertexArray, framebuffer, renderbuffer, shader, program };

/// Move-only; empty after a move. Deletes its object while the context is alive.
class Object {
public:
    Object() = default;
    Object(DevicePtr device, ObjectKind kind, GLuint name)
        : device_(std::move(device)), kind_(kind), name_(name)
    {
    }
    ~Object() { reset(); }
    Object(Object&& other) noexcept
        : device_(std::move(other.device_)),
          kind_(other.kind_),
          name_(std::exchange(other.name_, 0u))
    {
    }
    Object& operator=(Object&& other) noexcept
    {
        if (this != &other) {
            reset();
            device_ = std::move(other.device_);
            kind_ = other.kind_;
            name_ = std::exchange(other.name_, 0u);
        }
        return *this;
    }

    GLuint name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }
    void reset() noexcept;

private:
    DevicePtr device_;
    ObjectKind kind_ = ObjectKind::buffer;
    GLuint name_ = 0;
};

/// A new object; shaders and programs are made by their own functions. Throws Error(gl) where GL
/// gives no name.
Object createObject(const DevicePtr& device, ObjectKind kind);

/// Names the object for debuggers: "fbrdf:<text>". It must have been bound once.
void label(const Device& device, ObjectKind kind, const Object& object, const std::string& text);

}  // namespace fbrdf::gl
