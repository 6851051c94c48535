import { fetchWords } from '#words/say.ts'

export const load = () => fetchWords('files', 'share')
