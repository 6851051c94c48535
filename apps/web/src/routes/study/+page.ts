import { study } from '#features/study/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

export const load: PageLoad = () => fetchWords(...study.words)
