import { getContext, setContext, type Component } from 'svelte'
import type { Question } from '@botgarten/content/questions'

/** Draws what a question about Bo is about; `after`: what really happens, which no form shows. */
type Picture = Component<{ run: Question['run']; after: string | null }>
export type LoadPicture = () => Promise<Picture>

const key = Symbol('picture')
export const givePicture = (load: LoadPicture): void => void setContext(key, load)
export const takePicture = (): LoadPicture => getContext<LoadPicture>(key)
