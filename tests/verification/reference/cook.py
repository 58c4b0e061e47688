# scikit-fem, P2/P1 Taylor-Hood mixed u-p (plane strain): isochoric neo-Hooke + K/2 (J-1)^2, via perturbed Lagrangian
import sys, numpy as np
from skfem import *
from skfem.helpers import *
E,nu,q=240.565,0.4999,6.25
mu=E/(2*(1+nu)); K=E/(3*(1-2*nu))
n=int(sys.argv[1]); steps=int(sys.argv[2]) if len(sys.argv)>2 else 10
m=MeshQuad.init_tensor(np.linspace(0,1,n+1),np.linspace(0,1,n+1))
xi,eta=m.p
m=MeshQuad(np.array([48*xi,44*xi+eta*(44-28*xi)]),m.t).with_boundaries({'left':lambda x:x[0]<1e-9,'right':lambda x:x[0]>48-1e-9})
eu=ElementVector(ElementQuad2()); ep=ElementQuad1()
bu=Basis(m,eu,intorder=6); bp=bu.with_element(ep)
fb=FacetBasis(m,eu,facets=m.boundaries['right'],intorder=6)
load=LinearForm(lambda v,w: q*v[1]).assemble(fb)
def kin(w):
    H=w['u'].grad
    F=H+np.eye(2)[:,:,None,None]
    J=F[0,0]*F[1,1]-F[0,1]*F[1,0]
    cof=np.array([[F[1,1],-F[1,0]],[-F[0,1],F[0,0]]])  # J F^-T
    I1=np.einsum('ij...,ij...->...',F,F)+1.0
    return F,J,cof,I1
def P(F,J,cof,I1,p):
    Fit=cof/J
    return mu*J**(-2/3)*(F-I1/3*Fit)+p*cof
@LinearForm
def ru(v,w):
    F,J,cof,I1=kin(w); return ddot(P(F,J,cof,I1,w['p'].value),grad(v))
@LinearForm
def rp(qq,w):
    F,J,cof,I1=kin(w); return (J-1-w['p'].value/K)*qq
@BilinearForm
def kuu(u,v,w):
    F,J,cof,I1=kin(w); p=w['p'].value; dF=grad(u); Fit=cof/J
    dJ=ddot(cof,dF); dI=2*ddot(F,dF)
    dcof=np.array([[dF[1,1],-dF[1,0]],[-dF[0,1],dF[0,0]]])
    dFit=dcof/J-cof*dJ/J**2
    dP=mu*J**(-2/3)*(dF-dI/3*Fit-I1/3*dFit)-2/3*mu*J**(-5/3)*dJ*(F-I1/3*Fit)+p*dcof
    return ddot(dP,grad(v))
@BilinearForm
def kpu(u,qq,w):
    F,J,cof,I1=kin(w); return ddot(cof,grad(u))*qq
@BilinearForm
def kpp(p,qq,w): return -p*qq/K
from scipy.sparse import bmat
D=bu.get_dofs('left').all()
u=bu.zeros(); p=bp.zeros()
free=np.setdiff1d(np.arange(bu.N+bp.N),D)
for s in range(1,steps+1):
    for it in range(30):
        W=dict(u=bu.interpolate(u),p=bp.interpolate(p))
        W2=dict(u=bu.interpolate(u),p=bp.interpolate(p))
        R=np.concatenate([ru.assemble(bu,**W)-s/steps*load, rp.assemble(bp,**W)])
        if it>0 and np.abs(R[free]).max()<1e-9: break
        A=kuu.assemble(bu,**W); B=kpu.assemble(bu,bp,**W); C=kpp.assemble(bp,**W)
        Kt=bmat([[A,B.T],[B,C]]).tocsr()
        d=np.zeros(bu.N+bp.N); d[free]=__import__('scipy.sparse.linalg').sparse.linalg.spsolve(Kt[free][:,free].tocsc(),-R[free])
        if s==1 and it==0:
            pass
        u+=d[:bu.N]; p+=d[bu.N:]
    print(s,it,flush=True) if s==steps else None
def at(x,y):
    i=np.argmin(np.hypot(m.p[0]-x,m.p[1]-y)); return u[bu.nodal_dofs[1,i]]
print(n,'corner',at(48,60),'mid',at(48,52),'lower',at(48,44), 'linear scaled?')
