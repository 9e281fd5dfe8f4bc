// `wakesurf serve` with arguments it cannot serve: one line on standard error, and the right exit status.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <tuple>
#include <vector>

namespace wakesurf::tests {

TEST(ServeCommand, SaysInOneLineWhyItCannotServe) {
    const std::vector<std::tuple<std::string, int, std::string>> cases{
        {"/nonexistent --listen 127.0.0.1:0", 1, "nonexistent"},
        {"flow:nonsense --listen 127.0.0.1:0", 1, "lamb-oseen"},
        {"flow:abc --listen 192.0.2.1:0", 1, "192.0.2.1"},
        {"flow:abc --token-file /etc/hostname", 1, "32 to 512"},
        {"flow:abc --listen nonsense", 2, "HOST:PORT"},
        {"flow:abc --listen :8080", 2, "HOST:PORT"},
        {"flow:abc --listen 127.0.0.1:99999", 2, "HOST:PORT"},
        {"flow:abc --no-auth --listen 0.0.0.0:0", 2, "anybody"},
        {"flow:abc --no-auth --token-file x", 2, "--token-file"},
        {"flow:abc --origin evil", 2, "https://"},
        {"flow:abc --threads 0", 2, "--threads"},
        {"flow:abc --memory banana", 2, "banana"},
        {"flow:abc --nonsense", 2, "--nonsense"},
        {"flow:abc --tls-cert x", 2, "--tls-key"},
        {"flow:abc --tls-key x", 2, "--tls-cert"},
        {"flow:abc --listen 127.0.0.1:0 --tls-cert /nowhere/c --tls-key /nowhere/k", 1,
         "--tls-cert cannot be read"},
        {"flow:abc --listen 127.0.0.1:0 --tls-cert /etc/hostname --tls-key /etc/hostname", 1,
         "--tls-cert holds no PEM certificate"},
    };
    for (const auto& [arguments, status, words] : cases) {
        std::FILE* pipe = ::popen(
            (std::string(WAKESURF_BINARY) + " serve " + arguments + " 2>&1 >/dev/null").c_str(),
            "r");
        ASSERT_NE(pipe, nullptr);
        std::string text;
        std::array<char, 1024> part{};
        while (std::fgets(part.data(), part.size(), pipe) != nullptr)
            text += part.data();
        const int end = ::pclose(pipe);
        EXPECT_EQ(WEXITSTATUS(end), status) << arguments << "\n" << text;
        EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << arguments << "\n" << text;
        EXPECT_NE(text.find(words), std::string::npos) << arguments << "\n" << text;
    }
}

} // namespace wakesurf::tests
