// CommaLocale.h - for a test: a locale whose decimal sign is a comma, in C and in C++.
#pragma once
#include <unistd.h>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <locale>
#include <string>

namespace fbrdf::test {

/// Sets both locales as a host program with setlocale(LC_ALL, "") and std::locale::global does
/// under de_DE.UTF-8, and sets them back. The C++ one needs no installed locale. The C one is an
/// installed one, or is made by localedef; where neither can be had it stays as it is.
class CommaLocale {
public:
    CommaLocale() : c_(std::setlocale(LC_ALL, nullptr)), cpp_(std::locale())
    {
        std::locale::global(std::locale(std::locale::classic(), new Comma));
        if (std::setlocale(LC_ALL, kName)) return;
        ::setenv("LOCPATH", madeLocales().c_str(), 1);
        std::setlocale(LC_ALL, kName);
        ::unsetenv("LOCPATH");
    }
    ~CommaLocale()
    {
        std::locale::global(cpp_);
        std::setlocale(LC_ALL, c_.c_str());
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;

    /// True where C's printf writes a comma now.
    static bool setsC() { return std::string(std::localeconv()->decimal_point) == ","; }

private:
    static constexpr const char* kName = "de_DE.UTF-8";

    class Comma : public std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };

    /// A folder with the locale, made once a process and removed at its end.
    class Folder {
    public:
        Folder()
            : path((std::filesystem::temp_directory_path() /
                    ("fbrdf-locale-" + std::to_string(::getpid())))
                       .string())
        {
            std::filesystem::create_directories(path);
            const std::string command =
                "localedef -i de_DE -f UTF-8 '" + path + "/" + kName + "' >/dev/null 2>&1";
            [[maybe_unused]] const int status = std::system(command.c_str());
        }
        ~Folder()
        {
            std::error_code ignored;
            std::filesystem::remove_all(path, ignored);
        }
        std::string path;
    };
    static std::string madeLocales()
    {
        static const Folder folder;
        return folder.path;
    }

    std::string c_;
    std::locale cpp_;
};

}  // namespace fbrdf::test
