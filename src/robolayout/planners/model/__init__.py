"""A vision-language model as planner: client, prompts, groups, retries, ranking."""
