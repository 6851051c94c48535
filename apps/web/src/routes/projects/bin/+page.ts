import { projects } from '#features/projects/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords(...projects.words)
