#include "tests/cli/slurm_cluster.h"

#include "core/base/atomic_file.h"
#include "core/base/random.h"

#include <arpa/inet.h>
#include <spdlog/fmt/fmt.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <pwd.h>
#include <unistd.h>

namespace chiaro::test {

namespace fs = std::filesystem;

namespace {

/// Ports of this machine that nothing listens on.
std::vector<int> freePorts(int count) {
    std::vector<int> sockets, ports;
    for (int i = 0; i < count; ++i) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t length = sizeof address;
        sockets.push_back(socket(AF_INET, SOCK_STREAM, 0));
        auto* plain = reinterpret_cast<sockaddr*>(&address);
        if (bind(sockets.back(), plain, length) != 0 || getsockname(sockets.back(), plain, &length) != 0)
            continue;
        ports.push_back(ntohs(address.sin_port));
    }
    for (const int one : sockets) close(one);
    return ports;
}

std::string hostName() {
    char name[256] = {};
    gethostname(name, sizeof name - 1);
    const std::string all = name;
    return all.substr(0, all.find('.'));
}

constexpr const char* configuration = R"(ClusterName=chiaro
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/run/munge.socket,cred_expire=5
SlurmctldPidFile={folder}/run/slurmctld.pid
SlurmdPidFile={folder}/run/slurmd.pid
SlurmdSpoolDir={folder}/spool
StateSaveLocation={folder}/state
SlurmctldLogFile={folder}/log/slurmctld.log
SlurmdLogFile={folder}/log/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
KillWait=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
)";

}  // namespace

bool succeeds(const std::string& command) {
    return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
}

SlurmCluster::SlurmCluster() {
    setenv("PATH", (std::string(getenv("PATH")) + ":/usr/sbin:/sbin").c_str(), 1);
    for (const char* program : {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol"})
        if (!succeeds(std::string("command -v ") + program)) {
            m_problem = std::string(program) + " is not installed";
            return;
        }
    writeConfiguration();
    const std::string folder = m_folder.path().string();
    setenv("SLURM_CONF", (folder + "/slurm.conf").c_str(), 1);
    start({"munged", "--foreground", "--force", "--key-file=" + folder + "/munge.key",
           "--socket=" + folder + "/run/munge.socket", "--pid-file=" + folder + "/run/munged.pid",
           "--log-file=" + folder + "/log/munged.log", "--seed-file=" + folder + "/run/munged.seed"});
    for (int i = 0; i < 100 && !fs::exists(folder + "/run/munge.socket"); ++i) usleep(50'000);
    start({"slurmctld", "-D", "-i", "-f", folder + "/slurm.conf"});
    start({"slurmd", "-D", "-f", folder + "/slurm.conf", "-N", hostName()});
    for (int i = 0; i < 120; ++i) {
        if (isIdle()) return;
        usleep(250'000);
    }
    m_problem = "its node does not become idle";
}

SlurmCluster::~SlurmCluster() {
    if (!m_daemons.empty()) succeeds("timeout 10 scancel --partition=all; sleep 1");
    for (auto daemon = m_daemons.rbegin(); daemon != m_daemons.rend(); ++daemon) {
        kill(*daemon, SIGTERM);
        for (int i = 0; i < 100; ++i) {
            if (waitpid(*daemon, nullptr, WNOHANG) != 0) break;
            if (i == 99) kill(*daemon, SIGKILL);
            usleep(50'000);
        }
    }
    unsetenv("SLURM_CONF");
}

void SlurmCluster::writeConfiguration() const {
    fs::permissions(m_folder.path(), fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
    for (const char* name : {"run", "log", "spool", "state"}) fs::create_directories(m_folder / name);
    Random random{std::uint64_t(getpid())};
    std::string key;
    for (int i = 0; i < 1024; ++i) key += char(random.bits() & 0xff);
    writeFileAtomically(m_folder / "munge.key", key);
    fs::permissions(m_folder / "munge.key", fs::perms::owner_read | fs::perms::owner_write);
    const std::vector<int> ports = freePorts(2);
    writeFileAtomically(
        m_folder / "slurm.conf",
        fmt::format(configuration, fmt::arg("host", hostName()), fmt::arg("controller", ports.at(0)),
                    fmt::arg("node", ports.at(1)), fmt::arg("user", getpwuid(geteuid())->pw_name),
                    fmt::arg("folder", m_folder.path().string())));
}

void SlurmCluster::start(const std::vector<std::string>& words) {
    std::vector<char*> argv;
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    const std::string log = m_folder / ("log/" + words.front() + ".out");
    const pid_t daemon = fork();
    if (daemon == 0) {
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        setpgid(0, 0);
        const int file = open(log.c_str(), O_WRONLY | O_CREAT, 0600);
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        execvp(argv[0], argv.data());
        _exit(127);
    }
    m_daemons.push_back(daemon);
}

bool SlurmCluster::isIdle() const {
    return succeeds("timeout 5 sinfo --noheader --format=%T | grep -q '^idle$'");
}

}  // namespace chiaro::test
