import { here } from '#features/here/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords(...here.words)
