import { getContext, setContext } from 'svelte'

const key = Symbol('shown')

/** What stands in here is shown to a class: it may be worked with, and is not a picture of itself. */
export const giveShown = (): void => void setContext(key, true)
export const isShown = (): boolean => getContext<true | undefined>(key) ?? false
