import { fetchWords } from '#words/say.ts'

export const load = () => fetchWords('projects', 'files', 'open-roberta', 'share')
