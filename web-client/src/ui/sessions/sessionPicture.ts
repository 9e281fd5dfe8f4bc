// The picture of a session in the list. An image cannot show the login, so it is fetched; once it is looked
// at.
import { css, html, LitElement, nothing, type PropertyValues, type TemplateResult } from 'lit';

export class SessionPicture extends LitElement {
    static override properties = {
        session: {},
        look: {},
        fetchPicture: { attribute: false },
        address: { state: true },
    };
    declare session: string;
    /** Another one than before: the picture may be another as well. */
    declare look: number;
    declare fetchPicture: (session: string) => Promise<Blob | null>;
    declare address: string | null;
    private seen = false;
    private readonly observer = new IntersectionObserver((entries) => {
        if (!entries.some(({ isIntersecting }) => isIntersecting)) return;
        this.observer.disconnect();
        this.seen = true;
        void this.load();
    });

    static override styles = css`
        :host {
            display: block;
            width: 100%;
            height: 100%;
        }
        img {
            display: block;
            width: 100%;
            height: 100%;
            object-fit: cover;
        }
    `;

    constructor() {
        super();
        this.address = null;
    }

    override connectedCallback(): void {
        super.connectedCallback();
        this.observer.observe(this);
    }

    override disconnectedCallback(): void {
        super.disconnectedCallback();
        this.observer.disconnect();
        this.show(null);
    }

    protected override updated(changed: PropertyValues<this>): void {
        if (this.seen && (changed.has('session') || changed.has('look'))) void this.load();
    }

    override render(): TemplateResult | typeof nothing {
        return this.address === null ? nothing : html`<img alt="" src=${this.address} />`;
    }

    private async load(): Promise<void> {
        const { session, look } = this;
        const image = await this.fetchPicture(session);
        if (this.isConnected && session === this.session && look === this.look) this.show(image);
    }

    private show(image: Blob | null): void {
        if (this.address !== null) URL.revokeObjectURL(this.address);
        this.address = image === null ? null : URL.createObjectURL(image);
    }
}

customElements.define('wakesurf-session-picture', SessionPicture);
