import { schoolClass } from '#features/class/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords(...schoolClass.words)
