import { teacher } from '#features/teacher/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords(...teacher.words)
