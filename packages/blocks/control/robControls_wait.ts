import { waitingBlock } from '../parts/waits.ts'

export const robControls_wait = waitingBlock('robControls_wait', 'expert')
