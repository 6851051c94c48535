import { about } from '#features/about/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords(...about.words)
