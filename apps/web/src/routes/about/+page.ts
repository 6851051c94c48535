import { about } from '#features/about/feature.ts'
import { fetchWords } from '#words/say.ts'

export const load = () => fetchWords(...about.words)
