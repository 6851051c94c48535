import { schoolClass } from '#features/class/feature.ts'
import { fetchWords } from '#words/message.ts'
import type { PageLoad } from './$types'

export const load: PageLoad = async () => {
  const [{ Join }] = await Promise.all([schoolClass.load(), fetchWords(...schoolClass.words)])
  return { Join }
}
