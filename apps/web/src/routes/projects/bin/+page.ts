import { fetchLateWords } from '#words/say.ts'

export const load = () => fetchLateWords()
