import { loadGoals } from '#content/cards.ts'
import type { PageLoad } from './$types'

export const load: PageLoad = async () => ({ goals: await loadGoals() })
