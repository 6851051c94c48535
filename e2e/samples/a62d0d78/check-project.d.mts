import type { checkProject as now } from '../../../packages/classroom/projects/checked.ts'

export const checkProject: typeof now
