/** What the menu of a project offers. */
export type Deed = 'rename' | 'duplicate' | 'share' | 'saveFile' | 'saveOpenRoberta' | 'throw'
