import { projects } from '#features/projects/feature.ts'
import { fetchWords } from '#words/say.ts'

export const load = () => fetchWords(...projects.words)
