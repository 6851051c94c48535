import { trust } from '#features/trust/feature.ts'
import { fetchWords } from '#words/message.ts'

export const load = () => fetchWords(...trust.words)
