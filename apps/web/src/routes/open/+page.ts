import { share } from '#features/share/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords('files', ...share.words)
