import { share } from '#features/share/feature.ts'
import { fetchWords } from '#words/say.ts'

export const load = () => fetchWords('files', ...share.words)
