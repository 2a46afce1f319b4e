#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/result.h"

/// The queue of a cluster, by Slurm's own programs.
namespace frond {

/// How many tasks of these jobs (`12,13`) are in the queue, by state; `states` says which are counted
/// (`PENDING,RUNNING`, or `all`). None where Slurm does not answer.
std::map<std::string, int> slurm_tasks(const std::string& jobs, const std::string& states);

/// Whether a partition has that name.
bool has_slurm_partition(const std::string& name);

/// The names of the partitions that there are, sorted.
Result<std::vector<std::string>> slurm_partitions();

/// How many tasks an array may have.
int most_slurm_tasks();

/// Hands a job to the queue; the words are those of sbatch, --parsable among them. The number of the job.
Result<std::string> submit_to_slurm(const std::vector<std::string>& words);

/// Ends these jobs.
Errors cancel_in_slurm(const std::string& jobs);

}  // namespace frond
