import { json } from '@sveltejs/kit'
import { features } from '#app/features.ts'

export const prerender = true

/** What the features say of themselves, for those who measure the build. */
export const GET = () => json([...features.values()])
