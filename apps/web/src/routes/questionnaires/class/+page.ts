import { questionnaires } from '#features/questionnaires/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords(...questionnaires.words)
