import type { Project } from '../types.ts'

/** One line of JSON. What `parseProject` made comes back from it the same. */
export const writeProject = (project: Project): string => JSON.stringify(project)
